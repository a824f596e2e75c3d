package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelLight;
import io.github.lumbre.model.internal.ModelMaterial;
import java.io.IOException;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** One wrong number of a light, a camera or a material does not take the model away. */
class GltfReplacedTest {
  private static final String LIGHT = "extensions.KHR_lights_punctual.lights[0].";

  private static GltfFile textured() {
    GltfFile file = new GltfFile();
    file.add("nodes", "{'mesh': " + file.triangle(", 'material': 0") + "}");
    file.add("textures", "{'source': 0, 'sampler': 0}");
    file.add("images", "{'uri': 'data:,a'}");
    file.add("samplers", "{}");
    return file;
  }

  private static Model material(String json) throws ModelFormatException, IOException {
    GltfFile file = textured();
    file.add("materials", json);
    return file.read();
  }

  /** Each material is the one beside it, and its warning names the value and its replacement. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'alphaMode': 'blend' | 'alphaMode': 'BLEND'"
            + " | alphaMode: expected \"OPAQUE\", \"MASK\" or \"BLEND\", found \"blend\";"
            + " \"BLEND\" is used",
        "'alphaMode': 'GLASS' || alphaMode: expected \"OPAQUE\", \"MASK\" or \"BLEND\", found"
            + " \"GLASS\"; \"OPAQUE\" is used",
        "'alphaMode': 2 || alphaMode: expected \"OPAQUE\", \"MASK\" or \"BLEND\", found 2;"
            + " \"OPAQUE\" is used",
        "'alphaMode': 'MASK', 'alphaCutoff': -1 | 'alphaMode': 'MASK', 'alphaCutoff': 0"
            + " | alphaCutoff: expected at least 0, found -1; 0 is used",
        "'alphaMode': 'MASK', 'alphaCutoff': null | 'alphaMode': 'MASK'"
            + " | alphaCutoff: expected a number, found null; 0.5 is used",
        "'doubleSided': 1 || doubleSided: expected true or false, found 1; false is used",
        "'name': 3 || name: expected a text, found 3; none is used",
        "'emissiveFactor': 1 || emissiveFactor: expected an array, found 1; 0, 0, 0 is used",
        "'emissiveFactor': [1, -2, 1] | 'emissiveFactor': [1, 0, 1]"
            + " | emissiveFactor: expected at least 0, found -2; 0 is used",
        "'emissiveFactor': [1, 1e999, 1] | 'emissiveFactor': [1, 0, 1]"
            + " | emissiveFactor[1]: expected a finite number, found 1e999; 0 is used",
        "'emissiveFactor': [1e200, 0, 0], 'extensions': {'KHR_materials_emissive_strength':"
            + " {'emissiveStrength': 1e200}} | 'emissiveFactor': [1e200, 0, 0]"
            + " | extensions.KHR_materials_emissive_strength.emissiveStrength: expected a finite"
            + " radiance, found 1e200; 1 is used",
        "'extensions': {'KHR_materials_unlit': true} || extensions.KHR_materials_unlit: expected"
            + " an object, found true; none is used",
        "'pbrMetallicRoughness': null || pbrMetallicRoughness: expected an object, found null;"
            + " none is used",
        "'pbrMetallicRoughness': {'baseColorFactor': [0.5, 0.25, 0.125]}"
            + " | 'pbrMetallicRoughness': {'baseColorFactor': [0.5, 0.25, 0.125, 1]}"
            + " | pbrMetallicRoughness.baseColorFactor: expected 4 numbers, found 3; 1 is used for"
            + " the others",
        "'pbrMetallicRoughness': {'baseColorFactor': [0.5, 0.25, 0.125, 1, 7]}"
            + " | 'pbrMetallicRoughness': {'baseColorFactor': [0.5, 0.25, 0.125, 1]}"
            + " | pbrMetallicRoughness.baseColorFactor: expected 4 numbers, found 5; the first 4"
            + " are used",
        "'pbrMetallicRoughness': {'metallicFactor': '0'} | 'pbrMetallicRoughness': {}"
            + " | pbrMetallicRoughness.metallicFactor: expected a number, found \"0\"; 1 is used",
        "'pbrMetallicRoughness': {'roughnessFactor': -0.5}"
            + " | 'pbrMetallicRoughness': {'roughnessFactor': 0}"
            + " | pbrMetallicRoughness.roughnessFactor: expected 0 to 1, found -0.5; 0 is used",
        "'extensions': {'KHR_materials_ior': {'ior': 0.5}}"
            + " | 'extensions': {'KHR_materials_ior': {'ior': 1}}"
            + " | extensions.KHR_materials_ior.ior: expected 0 or 1 to 1e6, found 0.5; 1 is used",
        "'extensions': {'KHR_materials_ior': {'ior': 1e7}}"
            + " | 'extensions': {'KHR_materials_ior': {'ior': 1e6}}"
            + " | extensions.KHR_materials_ior.ior: expected 0 or 1 to 1e6, found 10000000;"
            + " 1000000 is used",
        "'extensions': {'KHR_materials_iridescence': {'iridescenceIor': 0.9}}"
            + " | 'extensions': {'KHR_materials_iridescence': {'iridescenceIor': 1}}"
            + " | extensions.KHR_materials_iridescence.iridescenceIor: expected 1 to 1e6, found"
            + " 0.9; 1 is used",
        "'extensions': {'KHR_materials_volume': {'thicknessFactor': 1, 'attenuationDistance': 0}}"
            + " | 'extensions': {'KHR_materials_volume': {'thicknessFactor': 1}}"
            + " | extensions.KHR_materials_volume.attenuationDistance: expected a number > 0, found"
            + " 0; infinity is used",
        "'extensions': {'KHR_materials_volume': {'thicknessFactor': 1, 'attenuationDistance':"
            + " 1e999}} | 'extensions': {'KHR_materials_volume': {'thicknessFactor': 1}}"
            + " | extensions.KHR_materials_volume.attenuationDistance: expected a number > 0, found"
            + " 1e999; infinity is used"
      })
  void wrongValuesOfMaterialsAreReplaced(String json, String same, String warning)
      throws ModelFormatException, IOException {
    Model model = material("{" + json + "}");
    Model other = material("{" + (same == null ? "" : same) + "}");
    ModelMaterial found = model.parts().get(0).material();
    ModelMaterial expected = other.parts().get(0).material();
    assertThat(found.inputs()).isEqualTo(expected.inputs());
    assertThat(found).usingRecursiveComparison().ignoringFields("inputs").isEqualTo(expected);
    assertThat(other.warnings()).isEmpty();
    assertThat(model.warnings()).containsExactly("materials[0]." + warning);
  }

  @Test
  void wrongNumbersOfTexturesAreReplaced() throws ModelFormatException, IOException {
    String texture =
        "{'normalTexture': {'index': 0, 'scale': '1', 'extensions': {'KHR_texture_transform':"
            + " {'offset': [1], 'rotation': null}}}}";
    GltfFile file = textured();
    file.set("samplers", "[{'wrapS': 1, 'magFilter': 'x'}]");
    file.add("materials", texture);
    Model model = file.read();
    String place = "materials[0].normalTexture.";
    assertThat(model.warnings())
        .containsExactlyInAnyOrder(
            place + "scale: expected a number, found \"1\"; 1 is used",
            place
                + "extensions.KHR_texture_transform.offset: expected 2 numbers, found 1; 0 is used"
                + " for the others",
            place
                + "extensions.KHR_texture_transform.rotation: expected a number, found null; 0 is"
                + " used",
            "samplers[0].wrapS: expected 33071, 33648 or 10497, found 1; 10497 is used",
            "samplers[0].magFilter: expected a number, found \"x\"; 0 is used");
    assertThat(model.parts().get(0).material().normalMap().orElseThrow().number()).isEqualTo(1);
  }

  private static Model placed(String light, String camera)
      throws ModelFormatException, IOException {
    GltfFile file = GltfFile.ofTriangle();
    file.set("extensions", "{'KHR_lights_punctual': {'lights': [" + light + "]}}");
    file.add("nodes", "{'extensions': {'KHR_lights_punctual': {'light': 0}}}");
    file.add("cameras", camera);
    file.add("nodes", "{'camera': 0}");
    return file.read();
  }

  private static Model lit(String light) throws ModelFormatException, IOException {
    return placed(light, "{'type': 'perspective', 'perspective': {'yfov': 1}}");
  }

  private static Model seen(String camera) throws ModelFormatException, IOException {
    return placed("{'type': 'point'}", camera);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'range': 0 || range: expected a number > 0, found 0; infinity is used",
        "'range': -3 || range: expected a number > 0, found -3; infinity is used",
        "'intensity': -2 | 'intensity': 0 | intensity: expected at least 0, found -2; 0 is used",
        "'intensity': 1e999 || intensity: expected a finite number, found 1e999; 1 is used",
        "'intensity': null || intensity: expected a number, found null; 1 is used",
        "'color': [1, -0.5, 1] | 'color': [1, 0, 1]"
            + " | color: expected at least 0, found -0.5; 0 is used",
        "'color': 'red' || color: expected an array, found \"red\"; 1, 1, 1 is used",
        "'name': [] || name: expected a text, found an array; none is used",
        "'spot': 3 || spot: expected an object, found 3; none is used",
        "'spot': {'outerConeAngle': 2} | 'spot': {'outerConeAngle': 1.5707963267948966}"
            + " | spot.outerConeAngle: expected at most pi/2, found 2; 1.5707963267948966 is used",
        "'spot': {'outerConeAngle': 0} || spot.outerConeAngle: expected a number > 0, found 0; pi/4"
            + " is used",
        "'spot': {'innerConeAngle': -1} || spot.innerConeAngle: expected 0 to outerConeAngle, found"
            + " -1; 0 is used",
        "'spot': {'innerConeAngle': 1, 'outerConeAngle': 0.5}"
            + " | 'spot': {'innerConeAngle': 0.5, 'outerConeAngle': 0.5}"
            + " | spot.innerConeAngle: expected 0 to outerConeAngle, found 1; 0.5 is used"
      })
  void wrongValuesOfLightsAreReplaced(String json, String same, String warning)
      throws ModelFormatException, IOException {
    Model model = lit("{'type': 'spot', " + json + "}");
    Model other = lit("{'type': 'spot'" + (same == null ? "" : ", " + same) + "}");
    assertThat(model.lights()).usingRecursiveComparison().isEqualTo(other.lights());
    assertThat(other.warnings()).isEmpty();
    assertThat(model.warnings()).containsExactly(LIGHT + warning);
  }

  /** Blender's exporter writes both: a hard edge, and a right angle as a 32-bit float. */
  @ParameterizedTest
  @CsvSource({"0.5, 0.5, 0.5", "1.3, 1.5707963705062866, 1.5707963267948966"})
  void spotLightsOfExportersNeedNoWarning(double inner, double outer, double found)
      throws ModelFormatException, IOException {
    Model model =
        lit(
            "{'type': 'spot', 'spot': {'innerConeAngle': %s, 'outerConeAngle': %s}}"
                .formatted(inner, outer));
    ModelLight light = model.lights().get(0);
    assertThat(light.innerCone()).isEqualTo(inner);
    assertThat(light.outerCone()).isEqualTo(found);
    assertThat(model.warnings()).isEmpty();
  }

  @Test
  void conesOfOtherLightsDoNotMatter() throws ModelFormatException, IOException {
    assertThat(lit("{'type': 'point', 'spot': {'outerConeAngle': 9}}").warnings()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"{}", "{'type': 'area'}", "{'type': 3}"})
  void lightsOfNoKnownTypeAreLeftOut(String json) throws ModelFormatException, IOException {
    Model model = lit(json);
    assertThat(model.lights()).isEmpty();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.warnings()).hasSize(1);
    assertThat(model.warnings().get(0))
        .startsWith(LIGHT + "type: expected \"directional\", \"point\" or \"spot\", found ")
        .endsWith("; the light is left out");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-1", "null", "1e999"})
  void wrongAspectRatiosAreThoseOfThePicture(String ratio)
      throws ModelFormatException, IOException {
    Model model =
        seen("{'type': 'perspective', 'perspective': {'yfov': 1, 'aspectRatio': " + ratio + "}}");
    assertThat(model.cameras().get(0).lens())
        .isEqualTo(new ModelCamera.Perspective(1, OptionalDouble.empty()));
    assertThat(model.warnings())
        .containsExactly(
            "cameras[0].perspective.aspectRatio: expected a number > 0, found "
                + ratio
                + "; that of the picture is used");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'type': 'fish' | type: expected \"perspective\" or \"orthographic\", found \"fish\"",
        "'type': 'perspective' | perspective: expected an object, found nothing",
        "'type': 'perspective', 'perspective': {} | perspective.yfov: expected a number > 0, found"
            + " nothing",
        "'type': 'perspective', 'perspective': {'yfov': 0} | perspective.yfov: expected a number >"
            + " 0, found 0",
        "'type': 'perspective', 'perspective': {'yfov': 4} | perspective.yfov: expected less than"
            + " pi, found 4",
        "'type': 'orthographic', 'orthographic': {'xmag': 1, 'ymag': 0} | orthographic.ymag:"
            + " expected a number > 0 and at most 1e150, found 0",
        "'type': 'orthographic', 'orthographic': {'xmag': 1, 'ymag': 1e300} | orthographic.ymag:"
            + " expected a number > 0 and at most 1e150, found 1e300"
      })
  void camerasWithoutWhatTheyNeedAreLeftOut(String json, String warning)
      throws ModelFormatException, IOException {
    Model model = seen("{" + json + "}");
    assertThat(model.cameras()).isEmpty();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.warnings())
        .containsExactly("cameras[0]." + warning + "; the camera is left out");
  }
}
