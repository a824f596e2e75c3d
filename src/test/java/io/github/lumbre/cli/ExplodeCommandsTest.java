package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.ModelSequence;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests {@code --explode}. */
class ExplodeCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 32x24 -s 2 --quiet --no-denoise";

  /** A part, by its least and largest coordinates. */
  private record Part(List<Double> min, List<Double> max) {
    double center(int axis) {
      return .5 * (min.get(axis) + max.get(axis));
    }

    boolean overlaps(Part other) {
      boolean isApart = false;
      for (int axis = 0; axis < 3; axis++) {
        isApart |= min.get(axis) >= other.max.get(axis) || other.min.get(axis) >= max.get(axis);
      }
      return !isApart;
    }
  }

  /** A plate with a bolt through it, and a nut below. */
  @BeforeEach
  void writeModels() throws IOException {
    StringBuilder vertices = new StringBuilder();
    StringBuilder faces = new StringBuilder();
    box(vertices, faces, 0, "plate", -30, 0, -20, 30, 6, 20);
    box(vertices, faces, 8, "bolt", 20, -10, 10, 24, 10, 14);
    box(vertices, faces, 16, "nut", 18, -6, 8, 26, -2, 16);
    Files.writeString(directory.resolve("a.obj"), "" + vertices + faces);
    // Pieces of one object.
    Files.writeString(
        directory.resolve("b.obj"), (vertices.toString() + faces).replaceAll("o .*\n", ""));
  }

  private static void box(
      StringBuilder vertices, StringBuilder faces, int first, String name, double... c) {
    faces.append("o ").append(name).append('\n');
    for (int i = 0; i < 8; i++) {
      vertices.append(
          String.format(
              Locale.ROOT,
              "v %s %s %s%n",
              c[(i & 1) == 0 ? 0 : 3],
              c[(i & 2) == 0 ? 1 : 4],
              c[(i & 4) == 0 ? 2 : 5]));
    }
    int[][] sides = {
      {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}
    };
    for (int[] side : sides) {
      faces.append('f');
      for (int corner : side) {
        faces.append(' ').append(first + corner + 1);
      }
      faces.append('\n');
    }
  }

  /** Writes a cube of side 2 around the origin, at several nodes. */
  private void writeCubes(String nodes, String extensions) throws IOException {
    ByteBuffer data = ByteBuffer.allocate(8 * 12 + 36 * 2 + 24).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < 8; i++) {
      data.putFloat((i & 1) * 2 - 1).putFloat((i & 2) - 1).putFloat((i & 4) / 2 - 1);
    }
    int[] corners = {
      0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1,
      3, 7, 1, 7, 5
    };
    for (int corner : corners) {
      data.putShort((short) corner);
    }
    data.putFloat(0).putFloat(0).putFloat(0).putFloat(1).putFloat(0).putFloat(0);
    Files.writeString(
        directory.resolve("a.gltf"),
        """
        {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], %s "nodes": %s,
         "meshes": [{"name": "cube",
           "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
         "accessors": [
           {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 8,
            "min": [-1, -1, -1], "max": [1, 1, 1]},
           {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 36},
           {"bufferView": 2, "componentType": 5126, "type": "VEC3", "count": 2}],
         "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96},
           {"buffer": 0, "byteOffset": 96, "byteLength": 72},
           {"buffer": 0, "byteOffset": 168, "byteLength": 24}],
         "buffers": [{"byteLength": 192, "uri": "data:application/octet-stream;base64,%s"}]}
        """
            .formatted(extensions, nodes, Base64.getEncoder().encodeToString(data.array())));
  }

  private Map<String, Part> parts(String line) {
    String json = runs("check " + line + " --json").out();
    JsonObject root = JsonParser.parseString(json).getAsJsonObject();
    Map<String, Part> parts = new LinkedHashMap<>();
    for (JsonElement each : root.getAsJsonArray("parts")) {
      JsonArray bounds = each.getAsJsonObject().getAsJsonArray("bounds");
      parts.put(
          each.getAsJsonObject().get("name").getAsString(),
          new Part(numbers(bounds.get(0)), numbers(bounds.get(1))));
    }
    return parts;
  }

  private static List<Double> numbers(JsonElement array) {
    return array.getAsJsonArray().asList().stream().map(JsonElement::getAsDouble).toList();
  }

  private static void assertApart(Map<String, Part> parts) {
    parts.forEach(
        (name, part) ->
            parts.forEach(
                (other, otherPart) ->
                    assertThat(!name.equals(other) && part.overlaps(otherPart))
                        .as(name + " and " + other)
                        .isFalse()));
  }

  @Test
  void partsMoveApartLinearly() {
    Map<String, Part> none = parts("T/a.obj");
    Map<String, Part> half = parts("T/a.obj --explode 0.5");
    Map<String, Part> all = parts("T/a.obj --explode 1");
    assertThat(none.get("plate").overlaps(none.get("bolt"))).isTrue();
    assertApart(all);
    for (String name : none.keySet()) {
      for (int axis = 0; axis < 3; axis++) {
        double middle = .5 * (none.get(name).center(axis) + all.get(name).center(axis));
        assertThat(half.get(name).center(axis)).isCloseTo(middle, offset(1e-9));
      }
      assertThat(all.get(name).center(0)).isEqualTo(none.get(name).center(0));
      assertThat(all.get(name).center(2)).isEqualTo(none.get(name).center(2));
    }
    assertThat(all.get("nut").max().get(1)).isLessThan(all.get("bolt").min().get(1));
    assertThat(all.get("bolt").max().get(1)).isLessThan(all.get("plate").min().get(1));
  }

  /** Turns a model by 40° around z, then by 30° around x. */
  private static String tilted(String obj) {
    StringBuilder turned = new StringBuilder();
    for (String line : obj.lines().toList()) {
      String[] words = line.split(" ", -1);
      if (words[0].equals("v")) {
        Vec3 at = turned(new Vec3(number(words[1]), number(words[2]), number(words[3])));
        line = String.format(Locale.ROOT, "v %.9f %.9f %.9f", at.x(), at.y(), at.z());
      }
      turned.append(line).append('\n');
    }
    return turned.toString();
  }

  private static Vec3 turned(Vec3 v) {
    double x = .766044443 * v.x() - .642787610 * v.y();
    double y = .642787610 * v.x() + .766044443 * v.y();
    return new Vec3(x, .866025404 * y - .5 * v.z(), .5 * y + .866025404 * v.z());
  }

  private static double number(String text) {
    return Double.parseDouble(text);
  }

  @Test
  void partsOfTiltedAssembliesMoveAlongItsAxes() throws IOException {
    Files.writeString(
        directory.resolve("tilted.obj"), tilted(Files.readString(directory.resolve("a.obj"))));
    Map<String, Part> none = parts("T/tilted.obj");
    Map<String, Part> all = parts("T/tilted.obj --explode 1");
    assertApart(all);
    Vec3 axis = turned(Vec3.Y);
    Map<String, Double> heights = new LinkedHashMap<>();
    none.forEach(
        (name, part) -> {
          Vec3 move = center(all.get(name)).minus(center(part));
          heights.put(name, center(all.get(name)).dot(axis));
          assertThat(move.minus(axis.times(move.dot(axis))).length()).isLessThan(1e-5);
        });
    assertThat(heights.get("nut")).isLessThan(heights.get("bolt"));
    assertThat(heights.get("bolt")).isLessThan(heights.get("plate"));
  }

  private static Vec3 center(Part part) {
    return new Vec3(part.center(0), part.center(1), part.center(2));
  }

  @Test
  void piecesOfOneObjectAreBodies() {
    Map<String, Part> all = parts("T/b.obj --explode 1");
    assertThat(all.keySet()).containsExactly("piece 1", "piece 2", "piece 3");
    assertApart(all);
  }

  @Test
  void childrenMoveWithTheirParentFirst() throws IOException {
    writeCubes(
        """
        [{"name": "root", "children": [1, 4]},
         {"name": "left", "mesh": 0, "children": [2, 3]},
         {"name": "child", "mesh": 0, "translation": [0.5, 0.6, 0]},
         {"mesh": 0, "translation": [0.5, 0, 0.7]},
         {"name": "right", "mesh": 0, "translation": [1.5, 0, 0]}]""",
        "");
    Map<String, Part> all = parts("T/a.gltf --explode 1");
    assertThat(all.keySet()).containsExactly("left", "child", "cube", "right");
    assertApart(all);
    double family =
        List.of("left", "child", "cube").stream()
            .mapToDouble(name -> all.get(name).max().get(0))
            .max()
            .orElseThrow();
    assertThat(all.get("right").min().get(0)).isGreaterThan(family);
  }

  @Test
  void copiesOfOneNodeAreBodies() throws IOException {
    writeCubes(
        """
        [{"name": "cubes", "mesh": 0, "extensions": {"EXT_mesh_gpu_instancing":
          {"attributes": {"TRANSLATION": 2}}}}]""",
        "\"extensionsUsed\": [\"EXT_mesh_gpu_instancing\"],");
    assertThat(parts("T/a.gltf")).hasSize(1);
    Map<String, Part> all = parts("T/a.gltf --explode 1");
    assertThat(all.keySet()).containsExactly("cubes", "cubes 2");
    assertApart(all);
    assertThat(all.get("cubes 2").min().get(0)).isGreaterThan(all.get("cubes").max().get(0));
  }

  @Test
  void factorZeroKeepsThePicture() throws IOException {
    runs("render T/a.obj -o T/a.png" + SMALL);
    runs("render T/a.obj -o T/b.png --explode 0" + SMALL);
    runs("render T/a.obj -o T/c.png --explode 1" + SMALL);
    assertThat(pixels("b.png")).isEqualTo(pixels("a.png"));
    assertThat(texts("b.png").get("SceneHash"))
        .isNotEmpty()
        .isEqualTo(texts("a.png").get("SceneHash"));
    assertThat(pixels("c.png")).isNotEqualTo(pixels("a.png"));
  }

  @Test
  void importedAndResumedPicturesAreTheSame() {
    runs("render T/a.obj -o T/a.png --explode 0.7 --section x=50%" + SMALL);
    runs("import T/a.obj -o T/scene.json --explode 0.7 --section x=50%");
    runs("render T/scene.json -o T/b.png" + SMALL);
    runs("render T/a.obj -o T/c.png --explode 0.7 --section x=50% --checkpoint T/a.film" + SMALL);
    runs("resume T/a.film -s 2 -o T/d.png --quiet");
    assertThat(pixels("b.png")).isEqualTo(pixels("a.png"));
    assertThat(pixels("d.png")).isEqualTo(pixels("a.png"));
  }

  /** The plane goes through the middle of the bolt, wherever that has moved. */
  @Test
  void planesCutTheAssembledModel() {
    Map<String, Part> all = parts("T/a.obj --explode 1 --section +y=0");
    assertThat(all.keySet()).containsExactly("bolt", "nut");
    assertThat(all.get("bolt").max().get(1) - all.get("bolt").min().get(1)).isEqualTo(10);
    assertApart(all);
  }

  @Test
  void rangesAreAnimationsWithOneCamera() throws IOException, SceneFormatException {
    runs("render T/a.obj -o T/a.gif --explode 0..1 --fps 2" + SMALL);
    File file = directory.resolve("a.gif").toFile();
    try (ImageInputStream in = ImageIO.createImageInputStream(file)) {
      ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
      reader.setInput(in);
      assertThat(reader.getNumImages(true)).isEqualTo(4);
    }
    runs("render T/a.obj -o T/b.png --explode 0..1 --fps 2" + SMALL);
    String again = "render T/a.obj -o T/b.png --explode 0..1 --fps 2 --continue";
    assertThat(said(again + SMALL.replace(" --quiet", ""))).contains("4 were complete");
    ModelSequence frames =
        ModelSequence.of(
            new SceneParser(),
            directory.resolve("a.obj"),
            Optional.empty(),
            Stage.DEFAULT,
            ModelSequence.Motion.explosion(0, 1, new FrameRate(2, 1)));
    SceneFile first = frames.frame(0);
    for (int i = 1; i < 4; i++) {
      SceneFile frame = frames.frame(i);
      assertThat(frame.hash()).isEqualTo(frames.hash(i)).isNotEqualTo(first.hash());
      assertThat(frame.scene().camera())
          .usingRecursiveComparison()
          .isEqualTo(first.scene().camera());
    }
  }

  @Test
  void wrongFactorsAreRefused() {
    for (String factor :
        List.of("1e308", "-1e308", "NaN", "-0.1", "1.01", "0..2", "0..0", "x", "0..")) {
      run("render T/a.obj -o T/no.png --explode " + factor)
          .assertFailed(ExitCodes.USAGE, "--explode");
    }
    run("render T/a.obj -o T/no.gif --animation walk --explode 0.5")
        .assertFailed(ExitCodes.USAGE, "--explode: cannot be combined with --animation");
    run("render T/a.obj -o T/no.png --pose a@1 --shutter 0.5 --explode 0.5")
        .assertFailed(ExitCodes.USAGE, "--explode: cannot be combined with --shutter");
    run("render T/a.obj -o T/no.gif --turntable 3 --explode 0..1")
        .assertFailed(ExitCodes.USAGE, "--explode: expected one number with --turntable");
    run("views T/a.obj -o T/no --explode 0..1")
        .assertFailed(ExitCodes.USAGE, "--explode: expected one factor, found a range");
    run("diff T/a.obj T/b.obj --explode 1").assertFailed(ExitCodes.USAGE, "--explode");
  }

  @Test
  void scenesStateTheFactor() throws IOException {
    runs("import T/a.obj -o T/scene.json --explode 0.5");
    String scene = Files.readString(directory.resolve("scene.json"));
    assertThat(scene).contains("\"explode\": 0.5");
    Files.writeString(
        directory.resolve("scene.json"), scene.replace("\"explode\": 0.5", "\"explode\": -1"));
    run("check T/scene.json")
        .assertFailed(ExitCodes.SCENE, "explode: expected a number from 0 to 1, found -1");
  }

  @Test
  void whatDoesNotFitIsNamed() throws IOException {
    StringBuilder vertices = new StringBuilder();
    StringBuilder faces = new StringBuilder();
    for (int i = 0; i < 30; i++) {
      box(vertices, faces, 8 * i, "shell" + i, -9 - .1 * i, -9, -9, 9 + .1 * i, 9, 9);
    }
    Files.writeString(directory.resolve("a.obj"), "" + vertices + faces);
    assertThat(runs("check T/a.obj --explode 1").err())
        .contains("explode: the boxes around \"shell0\" and \"shell")
        .contains("still overlap");
    Files.writeString(directory.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\no a\nf 1 2 3\n");
    assertThat(runs("check T/a.obj --explode 1").err()).contains("only one part");
    Files.writeString(
        directory.resolve("a.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\no a\nf 1 2 3\no b\nf 4 5 6\n");
    assertThat(runs("check T/a.obj --explode 1").err()).contains("no part is near another one");
  }

  @Test
  void dimensionsAreThoseOfTheAssembledModel() {
    String labels = " --size 320x240 -s 1 --quiet --view front --labels size --look lines";
    runs("render T/a.obj -o T/a.png --explode 1" + labels);
    runs("render T/a.obj -o T/b.png --explode 1 --hide nut" + labels);
    // The same text in the upper right corner, whatever the size of the exploded model.
    assertThat(upperRight("a.png")).isEqualTo(upperRight("b.png"));
  }

  private List<Integer> upperRight(String name) {
    BufferedImage picture = picture(name);
    return IntStream.range(0, 120 * 20)
        .mapToObj(i -> picture.getRGB(200 + i % 120, i / 120))
        .toList();
  }
}
