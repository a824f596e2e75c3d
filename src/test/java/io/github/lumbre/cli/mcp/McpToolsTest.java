package io.github.lumbre.cli.mcp;

import static io.github.lumbre.testing.Pictures.pixels;
import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import io.github.lumbre.cli.ModelSample;
import io.github.lumbre.cli.Outcome;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the tools as a client calls them. */
class McpToolsTest {
  private static final String SMALL = "'model':'sample.glb','width':32,'height':24";

  @TempDir private Path temporary;
  private Path folder;
  private McpClient client;

  @BeforeEach
  void start() throws IOException {
    folder = Files.createDirectory(temporary.resolve("parts"));
    ModelSample.write(folder);
    client = new McpClient((in, out) -> Mcp.serve(List.of(folder), in, out));
  }

  @AfterEach
  void end() throws IOException {
    client.close();
  }

  private static int[] picture(JsonObject result) throws IOException {
    JsonObject content = result.getAsJsonArray("content").get(0).getAsJsonObject();
    byte[] png = Base64.getDecoder().decode(content.get("data").getAsString());
    return pixels(ImageIO.read(new ByteArrayInputStream(png)));
  }

  /** Returns the pixels of a picture that a command line writes; T is the folder of the model. */
  private int[] commanded(String line, String name) throws IOException {
    Outcome outcome = Outcome.of(line.replace("T", temporary.toString()).split(" ")).done();
    return pixels(temporary.resolve(name));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'' | -s 1",
        ",'samples':3 | -s 3",
        ",'look':'lines' | -s 1 --look lines",
      },
      quoteCharacter = '`')
  void viewsAreThePictureOfTheCommandLine(String arguments, String flags) throws Exception {
    JsonObject result = client.result("views", SMALL + arguments.replace("''", ""));
    String line = "views T/parts/sample.glb --size 32x24 -o T/v " + flags;
    assertThat(picture(result)).isEqualTo(commanded(line, "v/views.png"));
    JsonArray views = result.getAsJsonObject("structuredContent").getAsJsonArray("views");
    assertThat(views)
        .extracting(view -> view.getAsJsonObject().get("view").getAsString())
        .containsExactly("front", "back", "left", "right", "top", "bottom", "iso");
  }

  @Test
  void viewsTellOfAllTheirSamplesAndOfLabelsWithoutRoom() throws Exception {
    String arguments =
        "'model':'sample.glb','width':160,'height':120,'samples':16,'labels':['parts']";
    String call = McpClient.line(1, "views", arguments);
    client.send(call.replace("\"_meta\":{", "\"_meta\":{\"progressToken\":7,"));
    JsonObject answer = client.next();
    assertThat(answer.has("method")).as(answer.toString()).isTrue();
    for (; answer.has("method"); answer = client.next()) {
      assertThat(answer.getAsJsonObject("params").get("total").getAsInt())
          .isEqualTo(160 * 120 * 16 * 7);
    }
    JsonArray notes =
        client
            .numbers("views", "'model':'sample.glb','width':16,'height':16,'labels':['parts']")
            .getAsJsonArray("notes");
    assertThat(notes.get(0).getAsString()).startsWith("front: ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "render | '' | --view 30,20",
        "render | ,'view':'front','samples':2 | --view front -s 2",
        "render | ,'highlight':['body'] | --view 30,20 --highlight body",
        "section | ,'planes':['x=50%'] | --view 30,20 --section x=50%",
        "section | ,'planes':['-y=40%'],'view':'top' | --view top --section -y=40%",
        "render | ,'look':'clay' | --view 30,20 --look clay",
        "render | ,'look':'clay,lines','labels':['axes'] | --view 30,20 --look clay,lines --labels"
            + " axes",
        "section | ,'look':'lines','planes':['x=50%'] | --view 30,20 --look lines --section x=50%"
      },
      quoteCharacter = '`')
  void rendersAreThePicturesOfTheCommandLine(String tool, String arguments, String flags)
      throws Exception {
    String line = "render T/parts/sample.glb --size 32x24 --quiet -o T/a.png " + flags;
    assertThat(picture(client.result(tool, SMALL + arguments.replace("''", ""))))
        .isEqualTo(commanded(line, "a.png"));
  }

  @Test
  void aPixelIsOfThePicture() throws Exception {
    JsonObject pixel = client.numbers("pixel", SMALL + ",'x':16,'y':12,'view':'front'");
    assertThat(pixel.get("shows").toString()).contains("body");
    assertThat(client.failure("pixel", SMALL + ",'x':32,'y':1"))
        .isEqualTo("x, y: expected a pixel of 32x24, found 32,1");
  }

  @Test
  void aModelIsDescribed() throws Exception {
    JsonObject numbers = client.numbers("describe", "'model':'sample.glb'");
    assertThat(numbers.get("triangles").getAsInt()).isEqualTo(4);
    assertThat(numbers.get("material_names")).hasToString("[\"paint\"]");
  }

  @Test
  void picturesAreCompared() throws Exception {
    HostileCallsTest.write(folder.resolve("a.png"), 0x808080);
    HostileCallsTest.write(folder.resolve("b.png"), 0xff8000);
    JsonObject same = client.numbers("compare", "'picture':'a.png','reference':'a.png'");
    assertThat(same.get("flip").getAsDouble()).isZero();
    assertThat(same.get("ssim").getAsDouble()).isEqualTo(1);
    JsonObject other = client.result("compare", "'picture':'a.png','reference':'b.png'");
    assertThat(other.getAsJsonObject("structuredContent").get("flip").getAsDouble())
        .isGreaterThan(.1);
    assertThat(picture(other)).hasSize(24 * 16);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "render | ,'view':'up' | view: ",
        "render | ,'view':'1e99,nan' | view: ",
        "render | ,'width':4096 | width: expected an integer from 16 to 1024, found 4096",
        "render | ,'hide':['nothing'] | sample.glb: hide: expected",
        "section | ,'planes':['x=-50%'] | sample.glb: section: ",
        "render | ,'planes':['x=1'] | \"planes\": expected one of the arguments",
        "section | ,'planes':['x=oops'] | planes: ",
        "views | ,'look':'clay,' | look: expected clay, lines or clay,lines, found clay,",
        "views | ,'highlight':'body' | highlight: expected an array of at most 64 strings"
      })
  void faultsOfArgumentsAreExplained(String tool, String arguments, String part) throws Exception {
    assertThat(
            client.failure(
                tool,
                SMALL.replace(",'width':32", arguments.contains("width") ? "" : ",'width':32")
                    + arguments))
        .contains(part)
        .doesNotContain("Exception");
  }

  @Test
  void aFileThatIsNoModelIsExplained() throws Exception {
    assertThat(client.failure("describe", "'model':'paint.png'"))
        .startsWith("\"paint.png\": expected a model: ");
    Files.writeString(folder.resolve("a.stl"), "solid a\nfacet\n");
    assertThat(client.failure("describe", "'model':'a.stl'")).startsWith("a.stl: ");
    Files.write(folder.resolve("b.glb"), new byte[100]);
    assertThat(client.failure("render", "'model':'b.glb'")).startsWith("b.glb: ");
  }

  /** Four calls at once see the same model from different sides. */
  @Test
  void callsAtOnceShareAModel() throws Exception {
    List<String> views = List.of("front", "top", "iso", "left", "30,20", "-40,70");
    List<String> expected = new ArrayList<>();
    for (String view : views) {
      expected.add(content(client.result("render", SMALL + ",'view':'" + view + "'")));
    }
    for (int round = 0; round < 3; round++) {
      for (int i = 0; i < views.size(); i++) {
        client.send(i, "render", SMALL + ",'view':'" + views.get(i) + "'");
      }
      for (int i = 0; i < views.size(); i++) {
        JsonObject answer = client.next();
        assertThat(content(answer.getAsJsonObject("result")))
            .isEqualTo(expected.get(answer.get("id").getAsInt()));
      }
    }
  }

  private static String content(JsonObject result) {
    JsonElement content = result.get("content");
    return content.toString();
  }
}
