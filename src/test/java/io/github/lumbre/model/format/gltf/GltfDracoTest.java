package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.draco.DracoSamples;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import java.io.IOException;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Compressed primitives of glTF files are read as others are. */
class GltfDracoTest {
  private static final String REQUIRED = "['KHR_draco_mesh_compression']";
  private static final String PLACE =
      "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression";

  /** A file with one compressed primitive of 256 faces and 212 points. Mutable. */
  private static final class Compressed {
    private final GltfFile file = new GltfFile();
    private String attributes = "";
    private String ids = "";
    private String indices = "";

    private Compressed with(String name, int id, String accessor) {
      return with(name, id, file.add("accessors", "{" + accessor + "}"));
    }

    private Compressed with(String name, int id, int accessor) {
      attributes += (attributes.isEmpty() ? "" : ", ") + "'" + name + "': " + accessor;
      ids += (ids.isEmpty() ? "" : ", ") + "'" + name + "': " + id;
      return this;
    }

    private Compressed withIndices(int accessor) {
      indices = ", 'indices': " + accessor;
      return this;
    }

    private Compressed positions() {
      return with("POSITION", 0, "'componentType': 5126, 'type': 'VEC3', 'count': 212");
    }

    private Compressed corners(int count) {
      String accessor = "{'componentType': 5123, 'type': 'SCALAR', 'count': " + count + "}";
      return withIndices(file.add("accessors", accessor));
    }

    private GltfFile of(byte[] stream, String more) {
      String primitive =
          ", 'extensions': {'KHR_draco_mesh_compression': {'bufferView': %d, 'attributes': {%s}}}%s"
              .formatted(file.view(stream, ""), ids, indices + more);
      file.meshNode(attributes, primitive);
      return file.set("extensionsUsed", REQUIRED);
    }

    private GltfFile required(byte[] stream, String more) {
      return of(stream, more).set("extensionsRequired", REQUIRED);
    }
  }

  private static Compressed all() {
    return new Compressed()
        .positions()
        .with("NORMAL", 1, "'componentType': 5126, 'type': 'VEC3', 'count': 212")
        .with("TEXCOORD_0", 2, "'componentType': 5126, 'type': 'VEC2', 'count': 212")
        .with(
            "COLOR_0", 3, "'componentType': 5121, 'type': 'VEC4', 'count': 212, 'normalized': true")
        .corners(768);
  }

  private static byte[] holes() {
    return DracoSamples.file("holes-5");
  }

  private static String refusal(GltfFile file) {
    ModelFormatException e = catchThrowableOfType(ModelFormatException.class, file::read);
    return e.kind() + " " + e.getMessage();
  }

  @Test
  void attributesAreDecoded() throws ModelFormatException, IOException {
    GltfFile file = all().required(holes(), "");
    ModelGeometry mesh = file.geometry();
    assertThat(mesh.triangleCount()).isEqualTo(256);
    assertThat(mesh.vertexCount()).isEqualTo(212);
    assertThat(mesh.uv0()).hasSize(424);
    for (int i = 0; i < 212; i++) {
      checkTorus(mesh, i);
    }
    assertThat(file.read().warnings()).isEmpty();
  }

  /** Checks that a vertex is on a torus with the radii 2 and 1, and has its normal. */
  private static void checkTorus(ModelGeometry mesh, int vertex) {
    double x = mesh.positions()[3 * vertex];
    double y = mesh.positions()[3 * vertex + 1];
    double z = mesh.positions()[3 * vertex + 2];
    double fromAxis = Math.sqrt(x * x + y * y);
    assertThat((fromAxis - 2) * (fromAxis - 2) + z * z).isBetween(.99, 1.01);
    assertThat(mesh.normals()[3 * vertex + 2]).isBetween(z - .02, z + .02);
    assertThat(mesh.colors()[4 * vertex + 3]).isEqualTo(1);
    float height = mesh.colors()[4 * vertex + 2] * 255 / 250;
    assertThat((double) height)
        .isBetween(1 - mesh.uv0()[2 * vertex + 1] - .01, 1.01 - mesh.uv0()[2 * vertex + 1]);
  }

  @Test
  void skinsAreDecoded() throws ModelFormatException, IOException {
    Compressed all =
        all()
            .with("JOINTS_0", 4, "'componentType': 5123, 'type': 'VEC4', 'count': 212")
            .with("WEIGHTS_0", 5, "'componentType': 5126, 'type': 'VEC4', 'count': 212");
    GltfFile file = all.required(holes(), "");
    file.add("nodes", "{'mesh': 0, 'skin': 0}");
    file.set("scenes", "[{'nodes': [1]}]").set("scene", "0");
    int joint = file.add("nodes", "{'translation': [10, 0, 0]}");
    String joints = ("," + joint).repeat(305).substring(1);
    file.set("scenes", "[{'nodes': [1, " + joint + "]}]");
    file.add("skins", "{'joints': [" + joints + "]}");
    ModelGeometry mesh = file.geometry();
    assertThat(Arrays.stream(mesh.positions()).max().getAsDouble()).isBetween(12.9, 13.1);
  }

  @Test
  void facesAreListsInEveryMode() throws ModelFormatException, IOException {
    GltfFile strip = new Compressed().positions().corners(300).required(holes(), ", 'mode': 5");
    assertThat(strip.geometry().triangleCount()).isEqualTo(256);
    GltfFile unindexed = new Compressed().positions().required(holes(), "");
    assertThat(unindexed.geometry().triangleCount()).isEqualTo(256);
  }

  @Test
  void primitivesWithTheSameDataShareArrays() throws ModelFormatException, IOException {
    GltfFile file = new Compressed().positions().corners(768).required(holes(), "");
    String primitive =
        "{'attributes': {'POSITION': 0}, 'indices': 1, 'extensions':"
            + " {'KHR_draco_mesh_compression': {'bufferView': 0, 'attributes': {'POSITION': 0}}}}";
    int mesh = file.add("meshes", "{'primitives': [" + primitive + ", " + primitive + "]}");
    file.add("nodes", "{'mesh': " + mesh + "}");
    Model model = file.read();
    assertThat(model.parts()).hasSize(3);
    ModelGeometry first = model.parts().get(0).geometry();
    assertThat(model.parts().get(2).geometry().positions()).isSameAs(first.positions());
    assertThat(model.parts().get(2).geometry().indices()).isSameAs(first.indices());
  }

  private static GltfFile triangleWith(byte[] stream) {
    Compressed triangle = new Compressed();
    int positions = triangle.file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    int indices = triangle.file.ints("SCALAR", 0, 1, 2);
    return triangle.with("POSITION", 0, positions).withIndices(indices).of(stream, "");
  }

  @Test
  void plainAccessorsReplaceDamagedData() throws ModelFormatException, IOException {
    byte[] damaged = holes();
    damaged[5] = 1;
    GltfFile file = triangleWith(damaged);
    assertThat(file.geometry().triangleCount()).isEqualTo(1);
    String reason =
        PLACE + ".bufferView: byte 7 of its Draco data: expected version 2.2, found 1.2";
    assertThat(file.read().warnings()).containsExactly(reason + "; the uncompressed mesh is used");
    assertThat(refusal(triangleWith(damaged).set("extensionsRequired", REQUIRED)))
        .isEqualTo("UNSUPPORTED " + reason);
    assertThat(refusal(all().of(damaged, ""))).isEqualTo("UNSUPPORTED " + reason);
  }

  @Test
  void moreFacesThanAnnouncedAreRefused() {
    assertThat(refusal(new Compressed().positions().corners(765).required(holes(), "")))
        .isEqualTo(
            "MALFORMED "
                + PLACE
                + ".bufferView: byte 16 of its Draco data: expected at most 255 faces, found 256");
  }

  @Test
  void otherNumbersOfElementsAreReported() throws ModelFormatException, IOException {
    GltfFile file =
        new Compressed()
            .with("POSITION", 0, "'componentType': 5126, 'type': 'VEC3', 'count': 213")
            .corners(771)
            .required(holes(), "");
    assertThat(file.geometry().vertexCount()).isEqualTo(212);
    assertThat(file.read().warnings())
        .containsExactly(
            "accessors[1].count: expected 771 elements, found 768 in its Draco data",
            "accessors[0].count: expected 213 elements, found 212 in its Draco data");
  }

  @Test
  void attributesMustFit() {
    String vec2 = "'componentType': 5126, 'type': 'VEC2', 'count': 212";
    assertThat(refusal(new Compressed().with("POSITION", 0, vec2).required(holes(), "")))
        .isEqualTo(
            "MALFORMED accessors[0].type: expected 2 numbers per element, found 3 in its Draco"
                + " data");
    String vec3 = "'componentType': 5126, 'type': 'VEC3', 'count': 212";
    assertThat(refusal(new Compressed().with("POSITION", 9, vec3).required(holes(), "")))
        .isEqualTo(
            "MALFORMED "
                + PLACE
                + ".attributes.POSITION: expected the number of an attribute of its Draco data,"
                + " found 9");
    Compressed unnamed = new Compressed().positions();
    unnamed.ids = "";
    assertThat(refusal(unnamed.required(holes(), "")))
        .isEqualTo(
            "MALFORMED "
                + PLACE
                + ".attributes.POSITION: expected the number of an attribute, found nothing");
  }

  @Test
  void memoryIsLimited() {
    GltfFile file = all().required(holes(), "");
    ModelFormatException e =
        catchThrowableOfType(
            ModelFormatException.class,
            () ->
                GltfReader.read(
                    file.glb(),
                    GltfFile.EMPTY,
                    ModelOptions.DEFAULT,
                    new GltfBudget(Limits.NONE.withMemory(60_000))));
    assertThat(e.kind()).isEqualTo(Kind.TOO_LARGE);
    assertThat(e).hasMessageStartingWith(PLACE + ".bufferView: ");
  }

  @Test
  void mutantsAreReadOrRefused() throws IOException {
    GltfMutationTest.checkMutants(all().of(holes(), "").glb(), 0, 1000);
  }

  @Test
  @Tag("fuzz")
  void manyMutantsAreReadOrRefused() throws IOException {
    long seed = Long.getLong("lumbre.fuzz.seed", System.nanoTime());
    GltfMutationTest.checkMutants(all().of(holes(), "").glb(), seed, 100_000);
  }
}
