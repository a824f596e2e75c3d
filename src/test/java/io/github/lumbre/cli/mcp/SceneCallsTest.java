package io.github.lumbre.cli.mcp;

import static io.github.lumbre.testing.Pictures.pixels;
import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.Outcome;
import io.github.lumbre.scene.RenderSettings;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that tools show scenes in JSON, within the bounds of models. */
class SceneCallsTest {
  private static final String SCENE =
      """
      {"version": "2.1", "mainCameraId": 1,
       "renderOptions": {"width": 40, "height": 20, "samples": 3},
       "assets": [],
       "objects": [
         {"id": 1, "type": "Camera", "cameraType": "Pinhole", "fieldOfView": 60,
          "localPosition": {"x": 0, "y": 0, "z": -4}},
         {"type": "Light", "lightType": "Dome", "sky": "studio"},
         {"type": "Shape", "name": "ball", "shapeType": "Sphere", "radius": 1}]}
      """;

  @TempDir private Path temporary;
  private Path folder;
  private McpClient client;

  @BeforeEach
  void start() throws IOException {
    folder = Files.createDirectory(temporary.resolve("parts"));
    write("{", "{");
    client = new McpClient((in, out) -> Mcp.serve(List.of(folder), in, out));
  }

  private void write(String old, String replacement) throws IOException {
    Files.writeString(folder.resolve("s.json"), SCENE.replace(old, replacement));
  }

  @AfterEach
  void end() throws IOException {
    client.close();
  }

  private int[] picture(String arguments) throws Exception {
    JsonObject content =
        client
            .result("render", "'model':'s.json'" + arguments)
            .getAsJsonArray("content")
            .get(0)
            .getAsJsonObject();
    assertThat(content.has("data")).as(content.toString()).isTrue();
    byte[] png = Base64.getDecoder().decode(content.get("data").getAsString());
    return pixels(ImageIO.read(new ByteArrayInputStream(png)));
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      delimiter = '|',
      value = {
        "`` | `` ",
        "`` | --size 40x20 -s 3",
        ",'width':20 | --size 20x10",
        ",'height':30,'samples':2 | --size 60x30 -s 2",
        ",'width':30,'height':30 | --size 30x30"
      })
  void aSceneIsThePictureOfTheCommandLine(String arguments, String flags) throws Exception {
    String line = "render %s/parts/s.json --denoise --quiet -o %s/a.png %s";
    Outcome.of(line.formatted(temporary, temporary, flags).strip().split(" ")).done();
    assertThat(picture(arguments)).isEqualTo(pixels(temporary.resolve("a.png")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"path", "ray"})
  void allModesAreRendered(String mode) throws Exception {
    write("\"width\"", "\"mode\": \"" + mode + "\", \"width\"");
    assertThat(picture("")).hasSize(800);
  }

  @Test
  void aPixelNamesTheObject() throws Exception {
    JsonObject pixel = client.numbers("pixel", "'model':'s.json','x':20,'y':10");
    assertThat(pixel.get("part").getAsString()).isEqualTo("ball");
    assertThat(pixel.getAsJsonArray("position").get(2).getAsDouble()).isBetween(-1., -.99);
    assertThat(pixel.get("depth").getAsDouble()).isBetween(3., 3.01);
  }

  /** What a scene states beyond the bounds of tools does not count, and a note says so. */
  @Test
  void theBoundsOfToolsWin() throws Exception {
    String large = "4000, 'height': 1000, 'samples': 9000, 'shutter': 1, 'poses': 256";
    write("40, \"height\": 20, \"samples\": 3", large.replace('\'', '"'));
    JsonObject scene = client.numbers("describe", "'model':'s.json'");
    assertThat(scene.get("width").getAsInt()).isEqualTo(1024);
    assertThat(scene.get("height").getAsInt()).isEqualTo(256);
    assertThat(scene.get("samples_per_pixel").getAsInt()).isEqualTo(64);
    assertThat(scene.get("notes").toString())
        .contains("1024x256, not 4000x1000", "64 per pixel, not 9000", "poses: 64, not 256");
    assertThat(scene.get("shapes").getAsInt()).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({
    "60000, 1, -1, -1, 1024, 1", "1, 60000, -1, -1, 1, 1024", "300, 200, -1, 100, 150, 100",
    "300, 200, 16, -1, 16, 11", "9000, 3, -1, 1024, 1024, 1024", "3, 9000, 1024, -1, 1024, 1024",
    "500, 400, 64, 64, 64, 64"
  })
  void framesStayWithinBounds(int width, int height, int w, int h, int shownW, int shownH) {
    SceneFrame frame = new SceneFrame(given(w), given(h), Optional.empty(), 1024, 64);
    RenderSettings own = RenderSettings.builder().size(width, height).threads(1000).build();
    RenderSettings shown = frame.within(own);
    assertThat(shown.width()).isEqualTo(shownW);
    assertThat(shown.height()).isEqualTo(shownH);
    assertThat(shown.threads()).isEqualTo(RenderSettings.DEFAULT.threads());
  }

  private static Optional<Integer> given(int value) {
    return Optional.of(value).filter(v -> v >= 0);
  }

  @ParameterizedTest
  @CsvSource({
    "render, \"'view':'top'\", view: requires a model; a scene in JSON",
    "describe, \"'z_up':true\", z_up: requires a model",
    "section, \"'planes':['x=0']\", planes: requires a model",
    "views, \"'width':16\", '\"s.json\": expected a model: '",
  })
  void optionsOfModelsAreRefused(String tool, String argument, String message) throws Exception {
    String arguments = "'model':'s.json'," + argument.replace("\"", "");
    assertThat(client.failure(tool, arguments)).startsWith(message);
  }

  @Test
  void aWrongSceneIsExplained() throws Exception {
    write("\"radius\": 1", "\"radius\": -1");
    assertThat(client.failure("render", "'model':'s.json'"))
        .isEqualTo("s.json: $.objects[2].radius: expected a finite number > 0, found -1");
    write("\"version\"", "\"version");
    assertThat(client.failure("describe", "'model':'s.json'")).startsWith("s.json: ");
    assertThat(client.failure("render", "'model':'../s.json'")).contains("expected a file in ");
  }

  @ParameterizedTest
  @ValueSource(strings = {"../secret.obj", "link.obj", "/etc/passwd", "http://127.0.0.1/a.obj"})
  @DisabledOnOs(OS.WINDOWS)
  void filesOutsideAreNotRead(String name) throws Exception {
    Files.writeString(temporary.resolve("secret.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Files.createSymbolicLink(folder.resolve("link.obj"), temporary.resolve("secret.obj"));
    String model = "{\"type\": \"Model\", \"file\": \"" + name + "\"}, ";
    write("{\"type\": \"Shape\"", model + "{\"type\": \"Shape\"");
    assertThat(client.failure("render", "'model':'s.json'"))
        .startsWith("s.json: $.objects[2]")
        .contains("expected");
  }

  @Test
  void uploadsAreLimited() throws Exception {
    StringBuilder mesh = new StringBuilder("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    mesh.append("f 1 2 3\n".repeat(2_000_001));
    Files.writeString(folder.resolve("big.obj"), mesh);
    String model = "{\"type\": \"Model\", \"file\": \"big.obj\"}, ";
    write("{\"type\": \"Shape\"", model + "{\"type\": \"Shape\"");
    assertThat(client.failure("describe", "'model':'s.json'")).contains("2000000 triangles");
  }
}
