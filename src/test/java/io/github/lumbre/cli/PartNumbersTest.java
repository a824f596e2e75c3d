package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.model.internal.PartSelectionTest;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** Tests the numbers beside pictures of models, as JSON. */
class PartNumbersTest extends CommandFixture {
  private static final String FAST = " -s 1 --no-denoise";

  /** The corners of a box that is not centered; none hides another in the views of the tests. */
  private static final double[] LOW = {3, -1, 2};

  private static final double[] SIZE = {4, 2.5, 1.5};

  private List<JsonObject> json(String line) {
    Outcome outcome = run(line + " --json");
    assertThat(outcome.exitCode()).as(line + ": " + outcome.err()).isEqualTo(ExitCodes.OK);
    return outcome.out().lines().map(l -> JsonParser.parseString(l).getAsJsonObject()).toList();
  }

  private static List<JsonObject> objects(JsonObject parent, String key) {
    return StreamSupport.stream(parent.getAsJsonArray(key).spliterator(), false)
        .map(JsonElement::getAsJsonObject)
        .toList();
  }

  private static List<String> names(JsonObject parent, String key) {
    return objects(parent, key).stream().map(o -> o.get("name").getAsString()).toList();
  }

  private static double[] numbers(JsonArray array) {
    return StreamSupport.stream(array.spliterator(), false)
        .mapToDouble(JsonElement::getAsDouble)
        .toArray();
  }

  private static double[] corner(int number) {
    return new double[] {
      LOW[0] + (number & 1) * SIZE[0],
      LOW[1] + (number >> 1 & 1) * SIZE[1],
      LOW[2] + (number >> 2) * SIZE[2]
    };
  }

  /** Writes eight small cubes around the corners of a box, as objects c0 to c7. */
  private void writeCorners() throws IOException {
    StringBuilder text = new StringBuilder();
    int[][] faces = {
      {1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}
    };
    for (int number = 0; number < 8; number++) {
      text.append("o c").append(number).append('\n');
      for (int i = 0; i < 8; i++) {
        text.append('v');
        for (int axis = 0; axis < 3; axis++) {
          text.append(' ').append(corner(number)[axis] + ((i >> axis & 1) - .5) * .06);
        }
        text.append('\n');
      }
      for (int[] face : faces) {
        text.append('f');
        for (int vertex : face) {
          text.append(' ').append(vertex + 8 * number);
        }
        text.append('\n');
      }
    }
    Files.writeString(directory.resolve("corners.obj"), text);
  }

  /** Returns the pixel position and the depth of a point, by the matrix of a view. */
  private static double[] projected(JsonObject view, double... point) {
    double[] product = new double[4];
    for (int row = 0; row < 4; row++) {
      double[] m = numbers(view.getAsJsonArray("matrix").get(row).getAsJsonArray());
      product[row] = m[0] * point[0] + m[1] * point[1] + m[2] * point[2] + m[3];
    }
    return new double[] {product[0] / product[3], product[1] / product[3], product[2]};
  }

  /** Returns the center of what is drawn near a position. */
  private static double[] drawn(BufferedImage image, double x, double y) {
    double sum = 0;
    double sumX = 0;
    double sumY = 0;
    int reach = 4;
    for (int row = (int) y - reach; row <= y + reach; row++) {
      for (int column = (int) x - reach; column <= x + reach; column++) {
        if (row >= 0 && column >= 0 && row < image.getHeight() && column < image.getWidth()) {
          int alpha = image.getRGB(column, row) >>> 24;
          sum += alpha;
          sumX += alpha * (column + .5);
          sumY += alpha * (row + .5);
        }
      }
    }
    return new double[] {sumX / sum, sumY / sum};
  }

  private void assertDrawn(JsonObject view) throws IOException {
    BufferedImage image = ImageIO.read(Path.of(view.get("file").getAsString()).toFile());
    assertThat(image.getWidth()).isEqualTo(view.get("width").getAsInt());
    double[] depths = numbers(view.getAsJsonArray("depth"));
    for (int number = 0; number < 8; number++) {
      double[] expected = projected(view, corner(number));
      boolean isInside =
          expected[0] > 4
              && expected[1] > 4
              && expected[0] < image.getWidth() - 4
              && expected[1] < image.getHeight() - 4;
      if (isInside) {
        double[] found = drawn(image, expected[0], expected[1]);
        String what = view.get("file") + " corner " + number;
        assertThat(found[0]).as(what).isCloseTo(expected[0], within(1.));
        assertThat(found[1]).as(what).isCloseTo(expected[1], within(1.));
        assertThat(expected[2]).as(what).isBetween(depths[0] - .06, depths[1] + .06);
      }
    }
  }

  @Test
  void cornersAreDrawnWhereTheMatrixPutsThem() throws IOException {
    writeCorners();
    String flags = " --background transparent --size 200x150 -s 8 --no-denoise";
    for (String view : new String[] {"30,20", "iso", "-110,-35"}) {
      List<JsonObject> one = json("render T/corners.obj -o T/one.png --view " + view + flags);
      assertThat(names(one.get(0), "parts"))
          .containsExactly("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7");
      assertDrawn(objects(one.get(0), "views").get(0));
    }
    for (JsonObject frame : json("render T/corners.obj -o T/t.png --turntable 3" + flags)) {
      assertThat(objects(frame, "views")).hasSize(1);
      assertDrawn(objects(frame, "views").get(0));
    }
    json("render T/corners.obj -o T/crop.png --crop 75,10,100,125" + flags)
        .forEach(
            crop -> {
              JsonObject view = objects(crop, "views").get(0);
              assertThat(view.get("height").getAsInt()).isEqualTo(125);
              try {
                assertDrawn(view);
              } catch (IOException e) {
                throw new AssertionError(e);
              }
            });
  }

  /** A unit square in the middle of a parallel picture of 2 by 2 units, and one behind it. */
  private void writeSquares() throws IOException {
    GltfFile file = new GltfFile();
    file.add(
        "cameras",
        "{'type': 'orthographic', 'orthographic': {'xmag': 1, 'ymag': 1, 'znear': 0, 'zfar': 9}}");
    for (int i = 0; i < 2; i++) {
      float z = -3 * i;
      int positions = file.floats("VEC3", -.5f, -.5f, z, .5f, -.5f, z, .5f, .5f, z, -.5f, .5f, z);
      int indices = file.ints("SCALAR", 0, 1, 2, 0, 2, 3);
      file.mesh("'POSITION': " + positions, ", 'indices': " + indices);
    }
    file.add("nodes", "{'camera': 0, 'translation': [0, 0, 2]}");
    file.add("nodes", "{'mesh': 0, 'name': 'front\\u001b'}");
    file.add("nodes", "{'mesh': 1, 'name': 'back', 'translation': [0.2, 0, 0]}");
    Files.write(directory.resolve("squares.glb"), file.glb());
  }

  @Test
  void pixelsBoxesAndDepthsAreExactAndDoNotDependOnSamples() throws IOException {
    writeSquares();
    String line = "render T/squares.glb -o T/a.png --size 20x20 --no-denoise -s ";
    JsonObject summary = json(line + "1").get(0);
    JsonObject view = objects(summary, "views").get(0);
    assertThat(view.get("projection").getAsString()).isEqualTo("parallel");
    assertThat(numbers(view.getAsJsonArray("depth"))).containsExactly(2, 5);
    assertThat(view.get("visible_parts"))
        .hasToString(
            "[{\"name\":\"front\\\\u001b\",\"pixels\":100,\"box\":[5,5,15,15]},"
                + "{\"name\":\"back\",\"pixels\":20,\"box\":[15,5,17,15]}]");
    assertThat(projected(view, .5, -.5, 0)).containsExactly(15, 15, 2);
    assertThat(summary.get("unit").getAsString()).isEqualTo("meter");
    assertThat(summary.get("file_unit").getAsString()).isEqualTo("meter");
    assertThat(summary.get("triangles").getAsInt()).isEqualTo(4);
    JsonObject other = json(line + "3 --threads 1 --seed 5").get(0);
    assertThat(other.get("views")).isEqualTo(summary.get("views"));
    assertThat(other.get("parts")).isEqualTo(summary.get("parts"));
    JsonObject hidden = json(line + "1 --hide front*").get(0);
    assertThat(objects(hidden, "views").get(0).get("visible_parts").toString())
        .isEqualTo("[{\"name\":\"back\",\"pixels\":100,\"box\":[7,5,17,15]}]");
  }

  @Test
  void viewsAreThoseOfRender() throws IOException {
    writeCorners();
    String flags = " --ground --size 60x45" + FAST;
    JsonObject all = json("views T/corners.obj -o T/views" + flags).get(0);
    List<JsonObject> views = objects(all, "views");
    assertThat(views).hasSize(7);
    assertThat(views.get(6).get("file").getAsString()).endsWith("iso.png");
    JsonObject one = json("render T/corners.obj -o T/one.png --view iso" + flags).get(0);
    JsonObject iso = objects(one, "views").get(0);
    for (String key : new String[] {"matrix", "depth", "visible_parts", "visible_part_count"}) {
      assertThat(iso.get(key)).isEqualTo(views.get(6).get(key));
    }
    assertThat(all.get("bounds")).isEqualTo(one.get("bounds"));
    assertThat(all.get("exit_code").getAsInt()).isZero();
    JsonObject empty = json("render T/corners.obj -o T/c.png --crop 0,0,2,2" + flags).get(0);
    JsonObject nothing = objects(empty, "views").get(0);
    assertThat(nothing.get("visible_parts")).hasToString("[]");
    assertThat(nothing.has("depth")).isFalse();
    Outcome failed = run("views T/none.obj -o T/views --json");
    assertThat(failed.exitCode()).isEqualTo(ExitCodes.SCENE);
    assertThat(failed.out()).contains("\"exit_code\":3").contains("problems");
  }

  @Test
  void piecesHaveTheNamesByWhichTheyAreHidden() throws IOException {
    Files.write(directory.resolve("a.stl"), PartSelectionTest.tetrahedra(3));
    String flags = " --view iso --size 60x45" + FAST;
    JsonObject all = json("render T/a.stl -o T/a.png" + flags).get(0);
    assertThat(names(all, "parts")).containsExactly("piece 1", "piece 2", "piece 3");
    assertThat(objects(all, "parts").get(2).get("triangles").getAsInt()).isEqualTo(4);
    assertThat(objects(all, "parts").get(2).get("bounds"))
        .hasToString("[[4.0,0.0,0.0],[5.0,1.0,1.0]]");
    JsonObject view = objects(all, "views").get(0);
    assertThat(names(view, "visible_parts")).containsExactly("piece 1", "piece 2", "piece 3");
    List<Double> x = new ArrayList<>();
    for (JsonObject part : objects(view, "visible_parts")) {
      double[] box = numbers(part.getAsJsonArray("box"));
      double[] middle = projected(view, 2 * x.size() + .25, .25, .25);
      assertThat(middle[0]).isBetween(box[0], box[2]);
      assertThat(middle[1]).isBetween(box[1], box[3]);
      x.add(middle[0]);
    }
    JsonObject some = json("render T/a.stl -o T/b.png --hide *2" + flags).get(0);
    assertThat(names(some, "parts")).containsExactly("piece 1", "piece 3");
    assertThat(names(objects(some, "views").get(0), "visible_parts"))
        .containsExactly("piece 1", "piece 3");
  }

  /** The cut surfaces belong to the pieces that they close. */
  @Test
  void piecesStayWholeWhenTheyAreCut() throws IOException {
    Files.write(directory.resolve("a.stl"), PartSelectionTest.tetrahedra(3));
    JsonObject cut = json("check T/a.stl --section y=0.5").get(0);
    assertThat(names(cut, "parts")).containsExactly("piece 1", "piece 2", "piece 3");
    assertThat(cut.get("triangles").getAsInt()).isGreaterThan(3 * 4);
  }

  @Test
  void listsOfManyPartsAreShort() throws IOException {
    Files.write(directory.resolve("a.stl"), PartSelectionTest.tetrahedra(100_000));
    Outcome outcome = run("check T/a.stl --json");
    JsonObject all = outcome.json();
    assertThat(all.get("part_count").getAsInt()).isEqualTo(10_000);
    assertThat(objects(all, "parts")).hasSize(1_000);
    assertThat(outcome.out()).hasSizeLessThan(150_000);
    assertThat(run("check T/a.stl").out())
        .contains("\nparts      10000: \"piece 1\", ")
        .contains("\"piece 20\" and 9980 more\n");
  }
}
