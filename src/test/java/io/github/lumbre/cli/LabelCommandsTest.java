package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Image;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests labels on pictures of models. */
class LabelCommandsTest extends CommandFixture {
  /** Shows nothing but labels. */
  private static final String WHITE = " -s 1 --no-denoise --look lines --line-width 0.001";

  private static final String FAST = " -s 1 --no-denoise --background white";

  /** Two boxes of 40 x 25 x 12.5 together, with z up. */
  private static final String MODEL =
      box("block", 0, 0, 0, 40, 25, 5, 0) + box("knob", 10, 10, 5, 15, 15, 12.5, 8);

  private static String box(
      String name, double x, double y, double z, double x2, double y2, double z2, int from) {
    StringBuilder text = new StringBuilder("o " + name + "\n");
    for (int i = 0; i < 8; i++) {
      text.append("v ").append((i & 1) == 0 ? x : x2).append(' ').append((i & 2) == 0 ? y : y2);
      text.append(' ').append((i & 4) == 0 ? z : z2).append('\n');
    }
    for (String face : new String[] {"1572", "3486", "1265", "3784", "1342", "5687"}) {
      String corners = face.equals("1572") ? "1573" : face.equals("3486") ? "2486" : face;
      text.append('f');
      corners.chars().forEach(c -> text.append(' ').append(c - '0' + from));
      text.append('\n');
    }
    return text.toString();
  }

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(directory.resolve("a.obj"), MODEL);
  }

  private static double pixel(JsonArray matrix, int row, double[] point) {
    double[] sums = {0, 0};
    for (int i = 0; i < 4; i++) {
      sums[0] += matrix.get(row).getAsJsonArray().get(i).getAsDouble() * point[i];
      sums[1] += matrix.get(3).getAsJsonArray().get(i).getAsDouble() * point[i];
    }
    return sums[0] / sums[1];
  }

  /** The corners are found where the lines of the box are, by the matrix of the JSON. */
  @Test
  void boxIsWhereTheMatrixOfTheJsonHasIt() throws IOException {
    String line = "views T/a.obj --up z --size 320x240 --labels box --json -o T/v" + WHITE;
    JsonObject json = runs(line).json();
    JsonArray low = json.getAsJsonArray("bounds").get(0).getAsJsonArray();
    JsonArray high = json.getAsJsonArray("bounds").get(1).getAsJsonArray();
    for (JsonElement view : json.getAsJsonArray("views")) {
      JsonObject object = view.getAsJsonObject();
      String file = Path.of(object.get("file").getAsString()).getFileName().toString();
      JsonArray matrix = object.getAsJsonArray("matrix");
      BufferedImage image = picture("v/" + file);
      double[] expected = {1e9, 1e9, -1e9, -1e9};
      for (int corner = 0; corner < 8; corner++) {
        double[] point = {0, 0, 0, 1};
        for (int axis = 0; axis < 3; axis++) {
          point[axis] = ((corner >> axis & 1) == 0 ? low : high).get(axis).getAsDouble();
        }
        double x = pixel(matrix, 0, point);
        double y = pixel(matrix, 1, point);
        assertThat(darkest(image, x, y)).as(file + " " + corner).isLessThan(190);
        expected[0] = Math.min(expected[0], x);
        expected[1] = Math.min(expected[1], y);
        expected[2] = Math.max(expected[2], x);
        expected[3] = Math.max(expected[3], y);
      }
      double[] found = darkBounds(image);
      for (int i = 0; i < 4; i++) {
        // Lines are 1 pixel wide.
        double outside = expected[i] + (i < 2 ? -.5 : .5);
        assertThat(found[i]).as(file + " " + i).isCloseTo(outside, within(1.));
      }
    }
  }

  private static int darkest(BufferedImage image, double x, double y) {
    int darkest = 255;
    for (int row = (int) (y - 1); row <= (int) (y + 1); row++) {
      for (int column = (int) (x - 1); column <= (int) (x + 1); column++) {
        darkest = Math.min(darkest, image.getRGB(column, row) >> 8 & 0xff);
      }
    }
    return darkest;
  }

  /** Returns the box around what is not white. */
  private static double[] darkBounds(BufferedImage image) {
    double[] bounds = {1e9, 1e9, -1e9, -1e9};
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        if ((image.getRGB(x, y) >> 8 & 0xff) < 200) {
          bounds[0] = Math.min(bounds[0], x);
          bounds[1] = Math.min(bounds[1], y);
          bounds[2] = Math.max(bounds[2], x + 1);
          bounds[3] = Math.max(bounds[3], y + 1);
        }
      }
    }
    return bounds;
  }

  @Test
  void labelsHaveTheSameBitsForAnyNumberOfThreads() throws IOException {
    String line = "render T/a.obj --up z --view iso --size 300x200 --labels all --quiet" + FAST;
    runs(line + " -o T/one.png --threads 1");
    runs(line + " -o T/two.png --threads 2");
    assertThat(picture("one.png").getData().getDataBuffer().getSize()).isPositive();
    assertThat(pixels("one.png")).isEqualTo(pixels("two.png"));
    runs(line.replace(" --labels all", "") + " -o T/none.png");
    assertThat(pixels("none.png")).isNotEqualTo(pixels("one.png"));
  }

  @Test
  void viewsHaveThePicturesOfRender() throws IOException {
    String flags = " --up z --size 200x150 --labels all" + FAST;
    runs("views T/a.obj -o T/v" + flags);
    runs("render T/a.obj --view top -o T/top.png" + flags);
    assertThat(pixels("v/top.png")).isEqualTo(pixels("top.png"));
  }

  @Test
  void libraryDrawsTheLabelsOfTheStage() throws Exception {
    runs("render T/a.obj -o T/a.pfm --view iso --size 240x180 --labels size -s 1");
    Stage.View iso = Stage.View.of("iso");
    Stage stage = Stage.DEFAULT.seenFrom(iso).with(Stage.LABEL, List.of("size"));
    SceneParser parser =
        new SceneParser().overriding(s -> s.toBuilder().size(240, 180).samples(1).build());
    SceneFile file = StagedModel.read(directory.resolve("a.obj"), stage, parser).scene();
    Image plain = new PictureRenderer(file.settings()).render(file.scene());
    Image labeled = Stage.withDrawing(file, plain);
    assertThat(labeled.rgb()).isNotEqualTo(plain.rgb());
    assertThat(Files.readAllBytes(directory.resolve("a.pfm"))).isEqualTo(labeled.toPfm());
  }

  @Test
  void whatHasNoRoomIsReported() {
    Outcome outcome =
        runs("render T/a.obj -o T/a.png --view iso --size 64x64 --labels all --up z" + FAST);
    assertThat(outcome.err())
        .contains("a.png: no room for the axes")
        .contains("a.png: no names for 2 visible parts");
    assertThat(runs("views T/a.obj -o T/v --size 64x64 --labels axes" + FAST).err())
        .contains("iso.png: no room for the axes");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "render T/a.obj --labels axis -o T/a.png | --labels: expected all, or some of view,",
        "render T/a.obj --labels , -o T/a.png | --labels: expected all, or some of view,",
        "render T/a.obj --labels axes --checkpoint T/f.film -o T/a.png | does not record the"
            + " labels",
        "import T/a.obj --labels axes -o T/a.json | a scene file holds no labels",
        "render T/s.json --labels axes -o T/a.png | --labels: requires a model file"
      })
  void commandsRefuseLabelsThatTheyCannotDraw(String line, String message) throws IOException {
    Files.writeString(directory.resolve("s.json"), "{}");
    run(line.strip()).assertFailed(ExitCodes.USAGE, message);
  }
}
