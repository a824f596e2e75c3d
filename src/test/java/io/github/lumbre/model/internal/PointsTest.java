package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.format.gltf.GltfFile;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Points of glTF, OBJ, PLY and OFF files are spheres. */
class PointsTest {
  private static final String PLY = "ply\nformat ascii 1.0\nelement vertex %d\n";
  private static final String XYZ = "property float x\nproperty float y\nproperty float z\n";
  private static final String RGB =
      "property uchar red\nproperty uchar green\nproperty uchar blue\n";

  private final GltfFile file = new GltfFile();

  private static ModelFixture ply(String properties, String... vertices) {
    return new ModelFixture(
        "a.ply",
        PLY.formatted(vertices.length)
            + properties
            + "end_header\n"
            + String.join("\n", vertices)
            + "\n");
  }

  private static ModelFixture obj(String text) {
    return new ModelFixture("a.obj", text.replace(';', '\n') + "\n");
  }

  private static Model read(GltfFile gltf, ModelOptions options) throws ModelFormatException {
    return new ModelFixture("a.glb", gltf.glb()).with(options).read();
  }

  private static List<ModelSurface> surfaces(Model model) throws ModelFormatException {
    return new ModelScene(model, Transform.IDENTITY, Kernel.AUTO, Limits.NONE, false).surfaces();
  }

  private static Bounds3 bounds(Model model) throws ModelFormatException {
    return surfaces(model).stream()
        .map(surface -> surface.shape().bounds())
        .reduce(Bounds3.EMPTY, Bounds3::union);
  }

  private static void assertBounds(Model model, Vec3 min, Vec3 max) throws ModelFormatException {
    Bounds3 found = bounds(model);
    assertThat(found.min().minus(min).length()).as(found.toString()).isLessThan(1e-6);
    assertThat(found.max().minus(max).length()).as(found.toString()).isLessThan(1e-6);
  }

  private int node(String attributes, String primitive, String node) {
    int mesh = file.mesh(attributes, ", 'mode': 0" + primitive);
    return file.add("nodes", "{'mesh': " + mesh + node + "}");
  }

  private String positions(double... numbers) {
    return "'POSITION': " + file.floats("VEC3", numbers);
  }

  @Test
  void verticesOfOffWithoutFacesArePoints() throws ModelFormatException {
    String text = "COFF\n3 0 0\n0 0 0 255 0 0 255\n2 0 0 0 255 0 255\nnan 0 0 0 0 0 255\n";
    Model model = new ModelFixture("a.off", text).read();
    assertBounds(model, new Vec3(-1, -1, -1), new Vec3(3, 1, 1));
    assertThat(surfaces(model)).hasSize(1);
    assertThat(model.warnings()).containsExactly("left out points that are not finite numbers: 1");
    float[] colors = model.parts().get(0).geometry().colors();
    assertThat(colors).containsExactly(1, 0, 0, 1, 0, 1, 0, 1);
  }

  @Test
  void verticesOfPlyWithoutFacesArePoints() throws ModelFormatException {
    Model model =
        ply(XYZ + RGB + "element face 0\nproperty list uchar int vertex_indices\n", "0 0 0 255 0 0")
            .read();
    assertThat(model.warnings()).isEmpty();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.parts().get(0).geometry().isPoints()).isTrue();
    assertThat(model.parts().get(0).geometry().colors()).containsExactly(1, 0, 0, 1);
  }

  @Test
  void colorsOfPointsAreShown() throws ModelFormatException {
    Model model = ply(XYZ + RGB, "0 0 0 255 0 0", "3 0 0 0 128 255").read();
    NearestHit nearest = new NearestHit();
    nearest.aim(new Ray(new Vec3(3, 0, -9), Vec3.Z));
    ModelSurface surface = surfaces(model).get(0);
    assertThat(surface.shape().intersect(nearest)).isTrue();
    Rgb color = surface.shape().surfaceAt(nearest).vertexColor();
    assertThat(color.g()).isCloseTo(Srgb.decode(128 / 255.), within(1e-6));
    assertThat(color.b()).isEqualTo(1);
    assertThat(surface.emitters()).isEmpty();
  }

  @Test
  void brokenPointsAreLeftOut() throws ModelFormatException, IOException {
    Model cloud = ply(XYZ, "0 0 0", "nan 0 0", "1 0 0").read();
    assertThat(cloud.parts().get(0).geometry().positions()).containsExactly(0, 0, 0, 1, 0, 0);
    assertThat(cloud.warnings())
        .containsExactly("element vertex: left out points that are not finite numbers: 1");
    Model obj = obj("v 0 0 0;p 1 2;v nan 0 0").read();
    assertThat(obj.parts().get(0).geometry().positions()).containsExactly(0, 0, 0);
    assertThat(obj.warnings())
        .containsExactly("line 2: left out points that are not finite numbers: 1");
    node(positions(1, 2, 3, Double.NaN, 0, 0), "", "");
    Model gltf = file.read();
    assertThat(gltf.parts().get(0).geometry().positions()).containsExactly(1, 2, 3);
    assertThat(gltf.warnings())
        .containsExactly("meshes[0].primitives[0]: left out points that are not finite numbers: 1");
  }

  @Test
  void pointsOfObjArePartsBesideTheFaces() throws ModelFormatException {
    Model model =
        obj("v 0 0 0;v 1 0 0;v 0 1 0;v 5 5 5 .5 .5 .5;usemtl red;f 1 2 3;p 1 -1;p 4/1;mtllib a.mtl")
            .with("a.mtl", "newmtl red\nKd 1 0 0\n")
            .read();
    assertThat(model.parts()).hasSize(2);
    ModelPart points = model.parts().get(1);
    assertThat(points.geometry().positions()).containsExactly(0, 0, 0, 5, 5, 5);
    assertThat(points.geometry().colors()[4]).isEqualTo((float) Srgb.decode(.5));
    assertThat(points.material()).isEqualTo(model.parts().get(0).material());
    assertThat(obj("v 0 0 0;p 2").refusal())
        .isEqualTo("MALFORMED line 2: expected a vertex from 1 to 1, found 2");
  }

  @Test
  void anObjOfVerticesIsACloud() throws ModelFormatException {
    assertThat(obj("v 0 0 0;v 1 0 0").read().parts().get(0).geometry().itemCount()).isEqualTo(2);
    assertThat(obj("v 0 0 0;v 1 0 0;l 1 2").refusal()).contains("ignored statements \"l\"");
  }

  @Test
  void theRadiusIsHalfTheMedianDistance() throws ModelFormatException {
    // The nearest neighbors are 2, 2, 4 and 60 away; equal points do not count.
    ModelFixture cloud = ply(XYZ, "0 0 0", "0 0 0", "2 0 0", "6 0 0", "66 0 0");
    assertThat(cloud.read().pointRadius()).isEqualTo(1);
    assertThat(ply(XYZ, "7 7 7", "7 7 7").read().pointRadius()).isEqualTo(1);
    Model one = obj("v 0 0 0;v 10 0 0;v 10 10 0;v 10 10 .5;f 1 2 3;p 4").read();
    assertThat(one.pointRadius()).isEqualTo(.25);
  }

  private static ModelOptions points(double radius) {
    return ModelOptions.DEFAULT.with(ModelOption.POINT_RADIUS, radius);
  }

  @Test
  void theRadiusIsInTheUnitOfTheFile() throws ModelFormatException {
    ModelOptions options =
        new ModelOptions(Optional.empty(), Optional.empty(), Up.Z, 10)
            .with(ModelOption.POINT_RADIUS, .5);
    Model model = ply(XYZ, "0 0 0", "1 2 3").with(options).read();
    assertThat(model.pointRadius()).isEqualTo(5);
    assertBounds(model, new Vec3(-5, -5, -25), new Vec3(15, 35, 5));
    assertThatThrownBy(() -> options.with(ModelOption.POINT_RADIUS, 0.))
        .hasMessage("pointRadius: expected a number from 1e-100 to 1e100, found 0.0");
    Model tiny = ply(XYZ, "0 0 0").with(points(1e-100)).read();
    assertThat(surfaces(tiny)).hasSize(1);
    ModelFixture huge = ply(XYZ, "1e100 0 0").with(points(1e99));
    assertThatThrownBy(huge::read)
        .hasMessageContaining("expected a part within 1e100 of the origin, found one that extends");
  }

  @Test
  void nodesMovePointsAndKeepTheirRadius() throws ModelFormatException, IOException {
    node(positions(0, 0, 0, 1, 1, 1), "", ", 'scale': [3, 3, 3], 'translation': [1, 0, 0]");
    ModelOptions options = ModelOptions.DEFAULT.with(ModelOption.POINT_RADIUS, .5);
    assertBounds(read(file, options), new Vec3(.5, -.5, -.5), new Vec3(4.5, 3.5, 3.5));
    GltfFile uneven = new GltfFile();
    int mesh = uneven.mesh("'POSITION': " + uneven.floats("VEC3", 0, 0, 0, 1, 1, 1), ", 'mode': 0");
    uneven.add("nodes", "{'mesh': " + mesh + ", 'scale': [1, 2, 0]}");
    assertBounds(read(uneven, options), new Vec3(-.5, -.5, -.5), new Vec3(1.5, 2.5, .5));
  }

  @Test
  void indicesSelectPointsAlsoOfMovedVertices() throws ModelFormatException, IOException {
    String target = ", 'targets': [{'POSITION': %d}]";
    String morph =
        target.formatted(file.floats("VEC3", 0, 1, 0, 0, 2, 0, 0, 3, 0))
            + ", 'indices': "
            + file.ints("SCALAR", 2, 0, 2);
    node(positions(0, 0, 0, 1, 0, 0, 2, 0, 0), morph, ", 'weights': [1]");
    ModelGeometry points = file.read().parts().get(0).geometry();
    assertThat(points.positions()).containsExactly(0, 1, 0, 2, 3, 0);
    GltfFile wrong = new GltfFile();
    wrong.add(
        "nodes",
        "{'mesh': "
            + wrong.mesh(
                "'POSITION': " + wrong.floats("VEC3", 0, 0, 0),
                ", 'mode': 0, 'indices': " + wrong.ints("SCALAR", 1))
            + "}");
    assertThatThrownBy(wrong::read)
        .hasMessage("meshes[0].primitives[0].indices: expected vertices from 0 to 0, found 1");
  }

  @Test
  void skinsMovePoints() throws ModelFormatException, IOException {
    int joints = file.bytes(5121, "VEC4", "", 1, 0, 0, 0);
    int weights = file.floats("VEC4", 1, 0, 0, 0);
    String skinned = ", 'JOINTS_0': " + joints + ", 'WEIGHTS_0': " + weights;
    node(positions(1, 0, 0) + skinned, "", ", 'skin': 0");
    int joint = file.add("nodes", "{'translation': [0, 5, 0]}");
    file.add("skins", "{'joints': [" + joint + ", " + joint + "]}");
    Model model = file.read();
    assertThat(model.parts().get(0).geometry().positions()).containsExactly(1, 5, 0);
    assertThat(model.parts().get(0).geometry().isPoints()).isTrue();
  }

  @Test
  void copiesShareOneCloud() throws ModelFormatException, IOException {
    int places = file.floats("VEC3", 0, 0, 0, 10, 0, 0);
    node(
        positions(0, 0, 0, 1, 0, 0),
        "",
        ", 'extensions': {'EXT_mesh_gpu_instancing': {'attributes': {'TRANSLATION': %d}}}"
            .formatted(places));
    file.set("extensionsUsed", "['EXT_mesh_gpu_instancing']");
    Model model = read(file, ModelOptions.DEFAULT);
    assertThat(model.parts()).hasSize(2);
    assertThat(model.parts().get(0).geometry()).isSameAs(model.parts().get(1).geometry());
    assertBounds(model, new Vec3(-.5, -.5, -.5), new Vec3(11.5, .5, .5));
  }

  /** Without lighting, points would have their base color and emission. */
  @Test
  void pointsOfGltfAreMatte() throws ModelFormatException, IOException {
    file.add(
        "materials",
        "{'name': 'ink', 'emissiveFactor': [0, 0, 1], 'pbrMetallicRoughness':"
            + " {'baseColorFactor': [1, 0.5, 0, 1], 'roughnessFactor': 0}}");
    node(positions(0, 0, 0), ", 'material': 0", "");
    Model model = file.read();
    ModelMaterial material = model.parts().get(0).material();
    assertThat(material.name()).isEqualTo("ink");
    assertThat(material.input(MaterialParameter.METALLIC).number()).isZero();
    assertThat(material.input(MaterialParameter.BASE_COLOR).factor()).isEqualTo(new Rgb(1, .5, 0));
    assertThat(surfaces(model).get(0).emitters()).hasSize(1);
  }

  @Test
  void pointsCountAsTriangles() {
    ModelOptions two = ModelOptions.DEFAULT.limitedTo(Limits.NONE.withTriangles(2));
    String message = "expected at most 2 points, found 3";
    assertThat(ply(XYZ, "0 0 0", "1 0 0", "2 0 0").with(two).refusal())
        .isEqualTo("TOO_LARGE element vertex: " + message);
    assertThat(obj("v 0 0 0;p 1 1 1").with(two).refusal()).isEqualTo("TOO_LARGE " + message);
    assertThat(obj("v 0 0 0;v 1 0 0;v 2 0 0").with(two).refusal())
        .isEqualTo("TOO_LARGE " + message);
    node(positions(0, 0, 0, 1, 0, 0, 2, 0, 0), "", "");
    assertThatThrownBy(() -> file.read(two)).hasMessage("nodes[0].mesh.primitives[0]: " + message);
  }

  @Test
  void pointsCompressedWithDracoAreLeftOut() throws ModelFormatException, IOException {
    int position = file.add("accessors", "{'componentType': 5126, 'type': 'VEC3', 'count': 3}");
    int view = file.view(new byte[8], "");
    node(
        "'POSITION': " + position,
        ", 'extensions': {'KHR_draco_mesh_compression': {'bufferView': %d, 'attributes': {}}}"
            .formatted(view),
        "");
    Model model = file.set("extensionsUsed", "['KHR_draco_mesh_compression']").read();
    assertThat(model.parts()).isEmpty();
    assertThat(model.warnings())
        .containsExactly("meshes[0].primitives[0]: points compressed with Draco are left out");
  }
}
