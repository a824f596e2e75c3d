package io.github.lumbre.model.difference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.model.internal.ModelReader;
import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a file states beside the places of vertices is compared. */
class FileChangesTest {
  /** A quadrilateral whose triangles meet at one of two diagonals. */
  private static final int[] ONE = {0, 1, 2, 0, 2, 3};

  private static final int[] OTHER = {0, 1, 3, 1, 2, 3};
  private static final int[] TURNED = {0, 2, 1, 0, 3, 2};
  private static final int[] HALF_TURNED = {0, 1, 2, 0, 3, 2};

  private static GltfFile file(int[] indices, String attribute, String type, double... values) {
    GltfFile file = new GltfFile();
    String attributes = "'POSITION': " + file.floats("VEC3", 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0);
    if (values.length > 0) {
      attributes += ", '%s': %d".formatted(attribute, file.floats(type, values));
    }
    int mesh = file.mesh(attributes, ", 'indices': " + file.ints("SCALAR", indices));
    file.add("nodes", "{'name': 'plate', 'mesh': " + mesh + "}");
    return file;
  }

  private static ModelDifference.Side side(GltfFile file) throws ModelFormatException, IOException {
    return new ModelDifference.Side(
        ModelReader.read("a.glb", file.glb(), GltfFile.EMPTY, ModelOptions.DEFAULT),
        ModelReader.motions("a.glb", file.glb(), GltfFile.EMPTY, ModelOptions.DEFAULT));
  }

  private static ModelDifference.Result between(GltfFile old, GltfFile now)
      throws ModelFormatException, IOException {
    return ModelDifference.between(side(old), side(now), 1e-5);
  }

  /** Returns the changes as texts: what happened, the name, the details. */
  private static List<String> changes(GltfFile old, GltfFile now)
      throws ModelFormatException, IOException {
    ModelDifference.Result result = between(old, now);
    assertThat(result.notCompared()).isEmpty();
    return result.changes().stream()
        .map(c -> c.kind() + " " + c.name() + ": " + String.join(", ", c.details()))
        .toList();
  }

  @Test
  void windingIsCompared() throws Exception {
    GltfFile one = file(ONE, "", "");
    assertThat(changes(one, file(OTHER, "", ""))).isEmpty();
    for (int[] turned : List.of(TURNED, HALF_TURNED)) {
      assertThat(changes(one, file(turned, "", "")))
          .containsExactly("CHANGED plate: triangles turned over");
    }
    assertThat(changes(file(TURNED, "", ""), file(TURNED, "", ""))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "COLOR_0, VEC3, 1 0 0 0 1 0 0 0 1 1 1 1, 1 0 0 0 1 0 0 0 1 1 1 .9, other vertex colors",
    "TEXCOORD_0, VEC2, 0 0 1 0 1 1 0 1, 0 0 1 0 1 1 0 .9, other texture coordinates",
    "TEXCOORD_1, VEC2, 0 0 1 0 1 1 0 1, 0 0 1 0 1 1 0 .9, other second texture coordinates",
    "NORMAL, VEC3, 0 0 1 0 0 1 0 0 1 0 0 1, 0 0 1 0 0 1 0 0 1 0 .6 .8, other normals"
  })
  void attributesAreCompared(
      String name, String type, String old, String now, String change) throws Exception {
    GltfFile before = file(ONE, name, type, numbers(old));
    assertThat(changes(before, file(ONE, name, type, numbers(now))))
        .containsExactly("CHANGED plate: " + change);
    assertThat(changes(before, file(OTHER, name, type, numbers(old)))).isEmpty();
    // A missing attribute has a default: white, no coordinates, and the normal of the face.
    List<String> removed = changes(before, file(ONE, "", ""));
    assertThat(removed.equals(List.of("CHANGED plate: " + change)))
        .isEqualTo(!name.equals("NORMAL"));
  }

  private static double[] numbers(String text) {
    return List.of(text.split(" ")).stream().mapToDouble(Double::parseDouble).toArray();
  }

  /** The two faces of a sheet of two quadrilaterals exchange what they show. */
  @Test
  void facesThatExchangeTheirMaterialsAreChanged() throws Exception {
    GltfFile[] files = {new GltfFile(), new GltfFile()};
    for (int i = 0; i < 2; i++) {
      GltfFile file = files[i];
      String attributes =
          "'POSITION': " + file.floats("VEC3", 0, 0, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 1);
      String primitive = "{'attributes': {%s}, 'indices': %s, 'material': %d}";
      String left = primitive.formatted(attributes, file.ints("SCALAR", 0, 1, 2), i);
      String right = primitive.formatted(attributes, file.ints("SCALAR", 1, 3, 4), 1 - i);
      file.add("meshes", "{'primitives': [" + left + "," + right + "]}");
      file.add("nodes", "{'name': 'sheet', 'mesh': 0}");
      file.add("materials", "{'pbrMetallicRoughness': {'metallicFactor': 0}}");
      file.add("materials", "{'pbrMetallicRoughness': {'metallicFactor': 1}}");
    }
    assertThat(changes(files[0], files[1]))
        .containsExactly("CHANGED sheet: another material on some faces");
    assertThat(changes(files[0], files[0])).isEmpty();
  }

  private static GltfFile with(Consumer<GltfFile> more) {
    GltfFile file = file(ONE, "", "");
    more.accept(file);
    return file;
  }

  private static GltfFile lit(String light, String place) {
    return with(
        file -> {
          file.set("extensionsUsed", "['KHR_lights_punctual']");
          file.set("extensions", "{'KHR_lights_punctual': {'lights': [" + light + "]}}");
          file.add(
              "nodes",
              "{'name': 'lamp', 'translation': [%s], 'extensions': {'KHR_lights_punctual':"
                  .formatted(place)
                  + " {'light': 0}}}");
        });
  }

  @Test
  void lightsAreCompared() throws Exception {
    GltfFile dark = file(ONE, "", "");
    GltfFile lamp = lit("{'type': 'point', 'intensity': 5}", "0, 3, 0");
    assertThat(changes(lamp, lamp)).isEmpty();
    assertThat(changes(dark, lamp)).containsExactly("ADDED light lamp: ");
    assertThat(changes(lamp, dark)).containsExactly("REMOVED light lamp: ");
    assertThat(changes(lamp, lit("{'type': 'point', 'intensity': 7}", "0, 3, 0")))
        .containsExactly("CHANGED light lamp: intensity (5, 5, 5) to (7, 7, 7)");
    assertThat(changes(lamp, lit("{'type': 'point', 'intensity': 5}", "0, 3, 0.5")))
        .containsExactly("CHANGED light lamp: position (0, 3, 0) m to (0, 3, 0.5) m");
    assertThat(changes(lamp, lit("{'type': 'directional', 'intensity': 5}", "0, 3, 0")).get(0))
        .contains("kind POINT to DIRECTIONAL", "direction none to (0, 0, -1)");
  }

  private static GltfFile animated(String path, double... values) {
    return with(
        file ->
            file.add(
                "animations",
                "{'name': 'go', 'samplers': [{'input': %d, 'output': %d}],"
                        .formatted(
                            file.floats("SCALAR", 0, 1),
                            file.floats(path.equals("rotation") ? "VEC4" : "VEC3", values))
                    + " 'channels': [{'sampler': 0, 'target': {'node': 0, 'path': '"
                    + path
                    + "'}}]}"));
  }

  @Test
  void animationsAreCompared() throws Exception {
    GltfFile still = file(ONE, "", "");
    GltfFile up = animated("translation", 0, 0, 0, 0, 1, 0);
    assertThat(changes(up, animated("translation", 0, 0, 0, 0, 1, 0))).isEmpty();
    assertThat(changes(still, up)).containsExactly("ADDED animation go: ");
    assertThat(changes(up, still)).containsExactly("REMOVED animation go: ");
    for (GltfFile other :
        List.of(
            animated("translation", 0, 0, 0, 0, 1, 1e-3), animated("scale", 0, 0, 0, 0, 1, 0))) {
      assertThat(changes(up, other)).containsExactly("CHANGED animation go: other keys");
    }
  }

  @Test
  void camerasAreCompared() throws Exception {
    GltfFile[] files = new GltfFile[2];
    for (int i = 0; i < 2; i++) {
      String lens = "{'type': 'perspective', 'perspective': {'yfov': %s, 'znear': 1}}";
      String angle = i == 0 ? "0.5" : "0.6";
      files[i] =
          with(
              file -> {
                file.add("cameras", lens.formatted(angle));
                file.add("nodes", "{'name': 'eye', 'camera': 0}");
              });
    }
    assertThat(changes(files[0], files[1]))
        .containsExactly("CHANGED camera eye: vertical field of view 28.65 to 34.38");
  }

  /** Weights of targets change nothing at rest, and are not compared. */
  @Test
  void whatIsNotComparedIsSaid() throws Exception {
    GltfFile file = new GltfFile();
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    file.mesh("'POSITION': " + positions, ", 'targets': [{'POSITION': " + positions + "}]");
    file.add("nodes", "{'mesh': 0}");
    ModelDifference.Result result = between(file, file);
    assertThat(result.changes()).isEmpty();
    assertThat(result.notCompared())
        .containsExactly("morph targets beyond the pose that is shown");
  }

  /** A wheel of 8 spokes, all of which its node moves, and a spoke that moves alone. */
  @ParameterizedTest
  @CsvSource({"0, 1", "0.2588190451, 0.9659258263"})
  void aMovedNodeIsOneChange(String y, String w) throws Exception {
    GltfFile[] files = {new GltfFile(), new GltfFile()};
    for (int i = 0; i < 2; i++) {
      GltfFile file = files[i];
      file.mesh("'POSITION': " + file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, .3), "");
      file.set("scene", "0").add("scenes", "{'nodes': [0, 1]}");
      String place = ", 'translation': [0, -8, 0], 'rotation': [0, %s, 0, %s]".formatted(y, w);
      file.add("nodes", "{'name': 'base', 'mesh': 0, 'translation': [0, 0, 30]}");
      file.add(
          "nodes",
          "{'name': 'wheel', 'mesh': 0, 'children': [2, 3, 4, 5, 6, 7, 8, 9]%s}"
              .formatted(i == 0 ? "" : place));
      for (int k = 2; k < 10; k++) {
        file.add(
            "nodes",
            "{'name': 'spoke %d', 'mesh': 0, 'translation': [%d, %d, 0]}".formatted(k, k * k, 2));
      }
    }
    ModelDifference.Result result = between(files[0], files[1]);
    assertThat(result.same()).isEqualTo(1);
    assertThat(result.changes()).hasSize(1);
    PartChange change = result.changes().get(0);
    assertThat(change.name()).isEqualTo("wheel");
    assertThat(change.nowParts()).hasSize(9).contains("wheel", "spoke 5");
    assertThat(change.degrees()).isCloseTo(y.equals("0") ? 0 : 30, within(.01));
    if (y.equals("0")) {
      assertThat(result.space().text(change.shift())).isEqualTo("(0, -8, 0) m");
    }
  }
}
