package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelLight;
import java.io.IOException;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the cameras and lights of glTF. */
class GltfPlacedTest {
  private final GltfFile file = new GltfFile();

  private ModelLight light(String json) throws ModelFormatException, IOException {
    file.set("extensions", "{'KHR_lights_punctual': {'lights': [" + json + "]}}");
    file.add(
        "nodes", "{'translation': [1, 2, 3], 'extensions': {'KHR_lights_punctual': {'light': 0}}}");
    return file.read().lights().get(0);
  }

  @Test
  void pointLightsAreRead() throws ModelFormatException, IOException {
    ModelLight light = light("{'type': 'point', 'name': 'bulb'}");
    assertThat(light.kind()).isEqualTo(ModelLight.Kind.POINT);
    assertThat(light.name()).isEqualTo("bulb");
    assertThat(light.location()).isEqualTo("nodes[0].extensions.KHR_lights_punctual");
    assertThat(light.intensity()).isEqualTo(Rgb.WHITE);
    assertThat(light.range()).isInfinite();
    assertThat(light.toWorld().point(Vec3.ZERO)).isEqualTo(new Vec3(1, 2, 3));
  }

  @Test
  void directionalLightsAreRead() throws ModelFormatException, IOException {
    ModelLight light =
        light("{'type': 'directional', 'color': [1, 0.5, 0], 'intensity': 4, 'range': 5}");
    assertThat(light.kind()).isEqualTo(ModelLight.Kind.DIRECTIONAL);
    assertThat(light.intensity()).isEqualTo(new Rgb(4, 2, 0));
    assertThat(light.range()).isEqualTo(5);
  }

  @Test
  void spotLightsAreRead() throws ModelFormatException, IOException {
    ModelLight light =
        light("{'type': 'spot', 'spot': {'innerConeAngle': 0.25, 'outerConeAngle': 0.5}}");
    assertThat(light.kind()).isEqualTo(ModelLight.Kind.SPOT);
    assertThat(light.innerCone()).isEqualTo(.25);
    assertThat(light.outerCone()).isEqualTo(.5);
  }

  @Test
  void conesHaveDefaults() throws ModelFormatException, IOException {
    ModelLight light = light("{'type': 'spot', 'spot': {}}");
    assertThat(light.innerCone()).isZero();
    assertThat(light.outerCone()).isEqualTo(Math.PI / 4);
  }

  @Test
  void perspectiveCamerasAreRead() throws ModelFormatException, IOException {
    file.add("cameras", "{'type': 'perspective', 'perspective': {'yfov': 0.5, 'znear': 1}}");
    file.add(
        "cameras",
        "{'type': 'perspective', 'perspective': {'yfov': 1, 'aspectRatio': 2, 'znear': 1}}");
    file.add("nodes", "{'camera': 0, 'name': 'left', 'translation': [1, 2, 3]}");
    file.add("nodes", "{'camera': 1}");
    ModelCamera camera = file.read().cameras().get(0);
    assertThat(camera.name()).isEqualTo("left");
    assertThat(camera.location()).isEqualTo("nodes[0].camera");
    assertThat(camera.lens()).isEqualTo(new ModelCamera.Perspective(.5, OptionalDouble.empty()));
    assertThat(camera.toWorld().point(Vec3.ZERO)).isEqualTo(new Vec3(1, 2, 3));
    assertThat(file.read().cameras().get(1).lens())
        .isEqualTo(new ModelCamera.Perspective(1, OptionalDouble.of(2)));
  }

  @Test
  void parallelCamerasAreRead() throws ModelFormatException, IOException {
    file.add("cameras", "{'type': 'orthographic', 'orthographic': {'xmag': 2, 'ymag': -3}}");
    file.add("nodes", "{'camera': 0}");
    Model model = file.read();
    assertThat(model.cameras().get(0).lens()).isEqualTo(new ModelCamera.Parallel(2, 3));
    assertThat(model.warnings())
        .containsExactly("cameras[0].orthographic.ymag: negative; its absolute value is used");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "EXT_structural_metadata",
        "EXT_manifold",
        "EXT_mesh_features",
        "FB_geometry_metadata",
        "FB_ngon_encoding",
        "KHR_collision_shapes",
        "KHR_xmp_json_ld",
        "KHR_physics_rigid_bodies",
        "OMI_collider",
        "VRMC_springBone",
        "VRMC_springBone_extended_collider",
        "VRMC_springBone_limit"
      })
  void extensionsThatCannotChangeThePictureGiveNoWarning(String name)
      throws ModelFormatException, IOException {
    file.set("extensionsUsed", "['" + name + "']");
    assertThat(file.read().warnings()).isEmpty();
    file.set("extensionsRequired", "['" + name + "']");
    assertThat(file.read().warnings()).isEmpty();
  }

  @Test
  void unsupportedExtensionsGiveWarnings() throws ModelFormatException, IOException {
    file.set("extensionsUsed", "['EXT_b', 'KHR_materials_ior', 'EXT_a', 'EXT_b']");
    file.set("extensionsRequired", "['KHR_mesh_quantization']");
    assertThat(file.read().warnings())
        .containsExactly(
            "extensionsUsed: EXT_a is not supported; the model may look different",
            "extensionsUsed: EXT_b is not supported; the model may look different");
  }

  @Test
  void warningOfScatteringVolumesNamesWhatThePictureLacks()
      throws ModelFormatException, IOException {
    file.set("extensionsUsed", "['KHR_materials_volume_scatter']");
    assertThat(file.read().warnings())
        .containsExactly(
            "extensionsUsed: KHR_materials_volume_scatter is not supported; volumes absorb light"
                + " and do not scatter it");
  }
}
