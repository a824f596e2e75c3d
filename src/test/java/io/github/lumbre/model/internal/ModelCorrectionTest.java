package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.model.internal.ModelCamera.Parallel;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ModelCorrectionTest {
  private static final String MATRIX =
      "'matrix': [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1]";

  private static ModelOptions options(Optional<Up> up, OptionalDouble unit) {
    return ModelOptions.DEFAULT.oriented(up, unit);
  }

  private static void assertNear(Vec3 found, double x, double y, double z) {
    assertThat(found.minus(new Vec3(x, y, z)).length()).as(found.toString()).isLessThan(1e-9);
  }

  private static Model read(GltfFile file, ModelOptions options) throws ModelFormatException {
    return new ModelFixture("a.glb", file.glb()).with(options).read();
  }

  private static GltfFile room() {
    GltfFile file = new GltfFile();
    file.add(
        "materials",
        "{'extensions': {'KHR_materials_transmission': {'transmissionFactor': 1},"
            + " 'KHR_materials_volume': {'thicknessFactor': 1, 'attenuationDistance': 50,"
            + " 'attenuationColor': [1, 0, 0]}}}");
    int mesh = file.triangle(", 'material': 0");
    file.add("nodes", "{'mesh': %d, 'name': 'a', %s}".formatted(mesh, MATRIX));
    file.add("nodes", "{'mesh': %d, 'name': 'b'}".formatted(mesh));
    file.add(
        "cameras",
        "{'type': 'orthographic', 'orthographic':"
            + " {'xmag': 4, 'ymag': 3, 'znear': 0, 'zfar': 100}}");
    file.add("nodes", "{'camera': 0, 'translation': [10, 20, 30]}");
    file.set(
        "extensions",
        "{'KHR_lights_punctual': {'lights':"
            + " [{'type': 'point', 'intensity': 7, 'range': 60}]}}");
    file.add(
        "nodes",
        "{'translation': [10, 20, 30], 'extensions': {'KHR_lights_punctual': {'light': 0}}}");
    return file;
  }

  @Test
  void glTfStandsUprightInTheStatedUnit() throws ModelFormatException {
    Model model = read(room(), options(Optional.of(Up.Z), OptionalDouble.of(.001)));
    assertNear(ModelFixture.mapped(model.parts().get(0), 1, 2, 3), .012, .036, -.024);
    assertNear(ModelFixture.mapped(model.parts().get(1), 1, 2, 3), .001, .003, -.002);
    assertNear(model.fromFile().point(new Vec3(1, 2, 3)), .001, .003, -.002);
    assertThat(model.unit()).isEqualTo("millimeter");
    ModelMaterial glass = model.parts().get(0).material();
    assertThat(glass.input(MaterialParameter.ATTENUATION_DISTANCE).number()).isEqualTo(.05);
    assertThat(model.parts().get(1).material()).isSameAs(glass);
    ModelLight light = model.lights().get(0);
    assertNear(light.toWorld().point(Vec3.ZERO), .01, .03, -.02);
    assertThat(light.range()).isEqualTo(.06);
    assertThat(light.intensity().r()).isEqualTo(7);
  }

  @Test
  void parallelCamerasSeeTheSamePart() throws ModelFormatException {
    Model model = read(room(), options(Optional.of(Up.Z), OptionalDouble.of(.001)));
    ModelCamera camera = model.cameras().get(0);
    Transform toWorld = camera.toWorld();
    assertNear(toWorld.point(Vec3.ZERO), .01, .03, -.02);
    assertNear(toWorld.vector(Vec3.Y), 0, 0, -1);
    assertThat(((Parallel) camera.lens()).halfHeight()).isCloseTo(.003, within(1e-12));
    assertThat(((Parallel) camera.lens()).halfWidth()).isCloseTo(.004, within(1e-12));
  }

  @Test
  void withoutOptionsTheFileDecides() throws ModelFormatException {
    Model model = read(room(), ModelOptions.DEFAULT);
    assertNear(ModelFixture.mapped(model.parts().get(0), 1, 2, 3), 12, 24, 36);
    assertThat(model.unit()).isEqualTo("meter");
    Model stated = read(room(), options(Optional.of(Up.Y), OptionalDouble.of(1)));
    assertThat(stated.parts().get(0).toWorld().toArray())
        .containsExactly(model.parts().get(0).toWorld().toArray());
    assertThat(stated.unit()).isEqualTo("meter");
  }

  @Test
  void anOddUnitHasNoName() throws ModelFormatException {
    Model model = read(room(), options(Optional.empty(), OptionalDouble.of(3)));
    assertThat(model.unit()).isEmpty();
    assertNear(ModelFixture.mapped(model.parts().get(1), 1, 2, 3), 3, 6, 9);
  }

  @Test
  void posesInMotionTurnToo() throws ModelFormatException {
    GltfFile file = GltfFile.ofTriangle();
    int times = file.floats("SCALAR", 0, 1);
    int places = file.floats("VEC3", 0, 0, 0, 0, 0, 8);
    file.add(
        "animations",
        "{'name': 'rise', 'samplers': [{'input': %d, 'output': %d}], 'channels':"
                .formatted(times, places)
            + " [{'sampler': 0, 'target': {'node': 0, 'path': 'translation'}}]}");
    Pose pose = new Pose("rise", 0, 1, 2);
    ModelOptions turned = options(Optional.of(Up.Z), OptionalDouble.of(10));
    Model model = read(file, turned.with(ModelOption.POSE, pose));
    assertThat(model.poses()).hasSize(2);
    assertNear(ModelFixture.mapped(model.poses().get(0).parts().get(0), 0, 0, 0), 0, 20, 0);
    assertNear(ModelFixture.mapped(model.poses().get(1).parts().get(0), 0, 0, 0), 0, 60, 0);
  }

  @ParameterizedTest
  @CsvSource({"0.001, millimeter", "0.0254, inch", "1, meter", "0.5, ''"})
  void unitsOfLengthHaveNames(double meters, String name) {
    assertThat(LengthUnit.nameOf(meters)).isEqualTo(name);
  }
}
