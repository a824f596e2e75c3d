package io.github.lumbre.model.format.gltf;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_COLOR;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_NORMAL;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.DIFFUSE_TRANSMISSION;
import static io.github.lumbre.material.MaterialParameter.DIFFUSE_TRANSMISSION_COLOR;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_COLOR;
import static io.github.lumbre.material.MaterialParameter.SHEEN_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.UvTransform;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the materials, textures and variants of glTF. */
class GltfMaterialTest {
  private final GltfFile file = new GltfFile();

  private Model model(String material) throws ModelFormatException, IOException {
    file.triangle(", 'material': 0");
    file.add("nodes", "{'mesh': 0}");
    file.add("materials", material);
    return file.read();
  }

  private ModelMaterial material(String json) throws ModelFormatException, IOException {
    return model(json).parts().get(0).material();
  }

  private ModelMaterial extended(String extension, String json)
      throws ModelFormatException, IOException {
    addTextures();
    return material("{'extensions': {'" + extension + "': " + json + "}}");
  }

  /** Adds textures 0 and 1 of one image each. */
  private void addTextures() {
    file.add("images", "{'bufferView': " + file.view(new byte[] {1, 2, 3}, "") + "}");
    file.add("images", "{'uri': 'data:image/png;base64,BAU='}");
    file.add("textures", "{'source': 0}");
    file.add("textures", "{'source': 1}");
  }

  private static byte[] image(Optional<ModelTexture> texture) {
    return texture.orElseThrow().image().encoded();
  }

  @Test
  void defaultsAreThoseOfTheFormat() throws ModelFormatException, IOException {
    ModelMaterial material = material("{'name': 'plain', 'pbrMetallicRoughness': {}}");
    assertThat(material.name()).isEqualTo("plain");
    assertThat(material.location()).isEqualTo("materials[0]");
    assertThat(material.input(BASE_COLOR)).isEqualTo(MaterialInput.of(Rgb.WHITE));
    assertThat(material.input(OPACITY).number()).isEqualTo(1);
    assertThat(material.input(METALLIC).number()).isEqualTo(1);
    assertThat(material.input(ROUGHNESS).number()).isEqualTo(1);
    assertThat(material.emission()).isEqualTo(MaterialInput.of(Rgb.BLACK));
    assertThat(material.alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(material.alphaCutoff()).isEqualTo(.5);
    assertThat(material.doubleSided()).isFalse();
    assertThat(material.unlit()).isFalse();
    assertThat(material.input(IOR).number()).isEqualTo(1.5);
    assertThat(material.normalMap()).isEmpty();
    assertThat(material.uses(ATTENUATION_DISTANCE)).isFalse();
  }

  @Test
  void primitivesWithoutMaterialShareTheDefault() throws ModelFormatException, IOException {
    file.triangle("");
    file.add("nodes", "{'mesh': 0}");
    ModelMaterial material = file.read().parts().get(0).material();
    assertThat(material.location()).isEmpty();
    assertThat(material.input(METALLIC).number()).isEqualTo(1);
  }

  @Test
  void metallicRoughnessIsRead() throws ModelFormatException, IOException {
    addTextures();
    ModelMaterial material =
        material(
            """
            {'pbrMetallicRoughness': {'baseColorFactor': [0.1, 0.2, 0.3, 0.4],
              'metallicFactor': 0.5, 'roughnessFactor': 0.6, 'baseColorTexture': {'index': 0},
              'metallicRoughnessTexture': {'index': 1, 'texCoord': 1}},
             'normalTexture': {'index': 1, 'scale': 0.7}, 'emissiveFactor': [0.8, 0.9, 1],
             'emissiveTexture': {'index': 0}, 'alphaMode': 'MASK', 'alphaCutoff': 0.25,
             'doubleSided': true}
            """);
    assertThat(material.input(BASE_COLOR).factor()).isEqualTo(new Rgb(.1, .2, .3));
    assertThat(image(material.input(BASE_COLOR).texture())).containsExactly(1, 2, 3);
    assertThat(material.input(OPACITY).number()).isEqualTo(.4);
    assertThat(material.input(OPACITY).channel()).isEqualTo(3);
    assertThat(material.input(OPACITY).texture()).isEqualTo(material.input(BASE_COLOR).texture());
    assertThat(material.input(METALLIC).number()).isEqualTo(.5);
    assertThat(material.input(METALLIC).channel()).isEqualTo(2);
    assertThat(image(material.input(METALLIC).texture())).containsExactly(4, 5);
    assertThat(material.input(METALLIC).texture().orElseThrow().uvSet()).isEqualTo(1);
    assertThat(material.input(ROUGHNESS).number()).isEqualTo(.6);
    assertThat(material.input(ROUGHNESS).channel()).isEqualTo(1);
    assertThat(material.normalMap().orElseThrow().number()).isEqualTo(.7);
    assertThat(material.normalMap().orElseThrow().texture().orElseThrow().image().location())
        .isEqualTo("images[1]");
    assertThat(material.emission().factor()).isEqualTo(new Rgb(.8, .9, 1));
    assertThat(material.emission().texture().orElseThrow().image())
        .isSameAs(material.input(BASE_COLOR).texture().orElseThrow().image());
    assertThat(material.alphaMode()).isEqualTo(AlphaMode.MASK);
    assertThat(material.alphaCutoff()).isEqualTo(.25);
    assertThat(material.doubleSided()).isTrue();
  }

  @Test
  void emissiveStrengthIsAFactor() throws ModelFormatException, IOException {
    ModelMaterial material =
        material(
            """
            {'emissiveFactor': [0.5, 0, 1],
             'extensions': {'KHR_materials_emissive_strength': {'emissiveStrength': 10}}}
            """);
    assertThat(material.emission().factor()).isEqualTo(new Rgb(5, 0, 10));
  }

  @Test
  void dielectricsAreRead() throws ModelFormatException, IOException {
    assertThat(extended("KHR_materials_ior", "{'ior': 1.4}").input(IOR).number()).isEqualTo(1.4);
  }

  @Test
  void specularIsRead() throws ModelFormatException, IOException {
    ModelMaterial material =
        extended(
            "KHR_materials_specular",
            """
            {'specularFactor': 0.5, 'specularTexture': {'index': 0},
             'specularColorFactor': [0, 1, 2], 'specularColorTexture': {'index': 1}}
            """);
    assertThat(material.input(SPECULAR).number()).isEqualTo(.5);
    assertThat(material.input(SPECULAR).channel()).isEqualTo(3);
    assertThat(image(material.input(SPECULAR).texture())).containsExactly(1, 2, 3);
    assertThat(material.input(SPECULAR_COLOR).factor()).isEqualTo(new Rgb(0, 1, 2));
    assertThat(image(material.input(SPECULAR_COLOR).texture())).containsExactly(4, 5);
  }

  @Test
  void transmissionIsRead() throws ModelFormatException, IOException {
    ModelMaterial material =
        extended(
            "KHR_materials_transmission",
            "{'transmissionFactor': 0.5, 'transmissionTexture': {'index': 0}}");
    assertThat(material.input(TRANSMISSION).number()).isEqualTo(.5);
    assertThat(material.input(TRANSMISSION).channel()).isZero();
    assertThat(material.input(TRANSMISSION).texture()).isPresent();
  }

  @Test
  void diffuseTransmissionIsRead() throws ModelFormatException, IOException {
    ModelMaterial material =
        extended(
            "KHR_materials_diffuse_transmission",
            """
            {'diffuseTransmissionFactor': 0.5, 'diffuseTransmissionTexture': {'index': 0},
             'diffuseTransmissionColorFactor': [0.1, 0.2, 0.3],
             'diffuseTransmissionColorTexture': {'index': 1}}
            """);
    assertThat(material.input(DIFFUSE_TRANSMISSION).number()).isEqualTo(.5);
    assertThat(material.input(DIFFUSE_TRANSMISSION).channel()).isEqualTo(3);
    assertThat(image(material.input(DIFFUSE_TRANSMISSION).texture())).containsExactly(1, 2, 3);
    assertThat(material.input(DIFFUSE_TRANSMISSION_COLOR).factor()).isEqualTo(new Rgb(.1, .2, .3));
    assertThat(image(material.input(DIFFUSE_TRANSMISSION_COLOR).texture())).containsExactly(4, 5);
  }

  /** Light enters a volume by either kind of transmission. */
  @ParameterizedTest
  @CsvSource({"0, 0, false", "0.5, 0, true", "0, 0.5, true"})
  void volumesNeedATransmission(double specular, double diffuse, boolean isUsed)
      throws ModelFormatException, IOException {
    ModelMaterial material =
        material(
            """
            {'extensions': {'KHR_materials_volume': {'thicknessFactor': 1},
              'KHR_materials_transmission': {'transmissionFactor': %s},
              'KHR_materials_diffuse_transmission': {'diffuseTransmissionFactor': %s}}}
            """
                .formatted(specular, diffuse));
    assertThat(material.uses(ATTENUATION_DISTANCE)).isEqualTo(isUsed);
  }

  @Test
  void thicknessMakesAVolume() throws ModelFormatException, IOException {
    ModelMaterial material =
        extended(
            "KHR_materials_volume",
            """
            {'thicknessFactor': 0.1, 'attenuationDistance': 2,
             'attenuationColor': [0.5, 1, 0]}
            """);
    assertThat(material.input(ATTENUATION_DISTANCE)).isEqualTo(MaterialInput.of(2));
    assertThat(material.input(ATTENUATION_COLOR)).isEqualTo(MaterialInput.of(new Rgb(.5, 1, 0)));
  }

  @Test
  void volumesAreClearByDefault() throws ModelFormatException, IOException {
    addTextures();
    ModelMaterial material =
        material(
            """
            {'extensions': {'KHR_materials_volume': {'thicknessFactor': 1},
              'KHR_materials_transmission': {'transmissionFactor': 1}}}
            """);
    assertThat(material.uses(ATTENUATION_DISTANCE)).isTrue();
    assertThat(material.input(ATTENUATION_DISTANCE).number()).isInfinite();
    assertThat(material.input(ATTENUATION_COLOR)).isEqualTo(MaterialInput.of(Rgb.WHITE));
  }

  @Test
  void zeroThicknessIsThinWalled() throws ModelFormatException, IOException {
    addTextures();
    ModelMaterial material =
        material(
            """
            {'extensions': {'KHR_materials_volume': {'attenuationDistance': 2},
              'KHR_materials_transmission': {'transmissionFactor': 1}}}
            """);
    assertThat(material.uses(ATTENUATION_DISTANCE)).isFalse();
  }

  @Test
  void clearcoatIsRead() throws ModelFormatException, IOException {
    ModelMaterial material =
        extended(
            "KHR_materials_clearcoat",
            """
            {'clearcoatFactor': 0.5, 'clearcoatTexture': {'index': 0},
             'clearcoatRoughnessFactor': 0.25, 'clearcoatRoughnessTexture': {'index': 1},
             'clearcoatNormalTexture': {'index': 1, 'scale': 2}}
            """);
    assertThat(material.input(CLEARCOAT).number()).isEqualTo(.5);
    assertThat(material.input(CLEARCOAT).channel()).isZero();
    assertThat(material.input(CLEARCOAT_ROUGHNESS).number()).isEqualTo(.25);
    assertThat(material.input(CLEARCOAT_ROUGHNESS).channel()).isEqualTo(1);
    assertThat(image(material.input(CLEARCOAT_ROUGHNESS).texture())).containsExactly(4, 5);
    assertThat(material.input(CLEARCOAT_NORMAL).number()).isEqualTo(2);
  }

  @Test
  void sheenIsRead() throws ModelFormatException, IOException {
    ModelMaterial material =
        extended(
            "KHR_materials_sheen",
            """
            {'sheenColorFactor': [0.1, 0.2, 0.3], 'sheenColorTexture': {'index': 0},
             'sheenRoughnessFactor': 0.5, 'sheenRoughnessTexture': {'index': 1}}
            """);
    assertThat(material.input(SHEEN_COLOR).factor()).isEqualTo(new Rgb(.1, .2, .3));
    assertThat(material.input(SHEEN_COLOR).texture()).isPresent();
    assertThat(material.input(SHEEN_ROUGHNESS).number()).isEqualTo(.5);
    assertThat(material.input(SHEEN_ROUGHNESS).channel()).isEqualTo(3);
  }

  private ModelMaterial glossy(String more) throws ModelFormatException, IOException {
    addTextures();
    return material(
        """
        {'pbrMetallicRoughness': {'baseColorFactor': [1, 0, 0, 1], 'roughnessFactor': 0.1},
         'extensions': {'KHR_materials_pbrSpecularGlossiness':
           {'diffuseFactor': [0.1, 0.2, 0.3, 0.4], 'diffuseTexture': {'index': 0},
            'specularFactor': [0.5, 0.6, 0.7], 'glossinessFactor': 0.8,
            'specularGlossinessTexture': {'index': 1, 'texCoord': 1}}\
        """
            + more
            + "}}");
  }

  /** Of both models of a material, the extension's rule selects specular-glossiness. */
  @Test
  void specularGlossinessReplacesMetallicRoughness() throws ModelFormatException, IOException {
    ModelMaterial material = glossy("");
    assertThat(material.glossy()).isTrue();
    assertThat(material.input(BASE_COLOR).factor()).isEqualTo(new Rgb(.1, .2, .3));
    assertThat(image(material.input(BASE_COLOR).texture())).containsExactly(1, 2, 3);
    assertThat(material.input(OPACITY).number()).isEqualTo(.4);
    assertThat(material.input(OPACITY).channel()).isEqualTo(3);
    assertThat(image(material.input(OPACITY).texture())).containsExactly(1, 2, 3);
    assertThat(material.input(METALLIC)).isEqualTo(MaterialInput.of(0));
    assertThat(material.input(IOR)).isEqualTo(MaterialInput.of(0));
    assertThat(material.input(SPECULAR_COLOR).factor()).isEqualTo(new Rgb(.5, .6, .7));
    assertThat(image(material.input(SPECULAR_COLOR).texture())).containsExactly(4, 5);
    assertThat(material.input(ROUGHNESS).number()).isEqualTo(.8);
    assertThat(material.input(ROUGHNESS).channel()).isEqualTo(3);
    assertThat(material.input(ROUGHNESS).texture())
        .isEqualTo(material.input(SPECULAR_COLOR).texture());
    assertThat(material.input(ROUGHNESS).texture().orElseThrow().uvSet()).isEqualTo(1);
  }

  @Test
  void specularGlossinessHasDefaults() throws ModelFormatException, IOException {
    ModelMaterial material = extended("KHR_materials_pbrSpecularGlossiness", "{}");
    assertThat(material.input(BASE_COLOR)).isEqualTo(MaterialInput.of(Rgb.WHITE));
    assertThat(material.input(SPECULAR_COLOR)).isEqualTo(MaterialInput.of(Rgb.WHITE));
    assertThat(material.input(ROUGHNESS).number()).isEqualTo(1);
    assertThat(material.input(OPACITY).number()).isEqualTo(1);
  }

  /** Converters write both, and what they mean by the extension is not what it means. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "`` | 'specularFactor': [0.9, 0.9, 0.9] | true",
        "'baseColorTexture': {'index': 0}, 'metallicFactor': 0 | 'diffuseTexture': {'index': 0},"
            + " 'specularFactor': [0.9, 0.9, 0.9] | false",
        "'baseColorTexture': {'index': 0} | 'diffuseTexture': {'index': 1} | false",
        "'baseColorTexture': {'index': 0} | 'specularFactor': [0.04, 0.04, 0.04] | false",
        "'roughnessFactor': 0.5 | 'diffuseTexture': {'index': 1} | true",
        "'metallicFactor': 0 | 'specularFactor': [0.2, 0.31, 0.2] | false",
        "'metallicFactor': 0 | 'glossinessFactor': 0.2 | false",
        "'metallicFactor': 0 | 'specularFactor': [0.3, 0.3, 0.3] | true",
        "'metallicFactor': 0.5 | 'specularFactor': [0.9, 0.9, 0.9] | true",
        "'roughnessFactor': 0.5 | 'specularFactor': [0.9, 0.9, 0.9] | true",
        "'metallicFactor': 0 | 'specularFactor': [0.9, 0.9, 0.9], 'specularGlossinessTexture':"
            + " {'index': 1} | true"
      })
  void oneOfTwoDescriptionsCounts(String core, String extension, boolean isGlossy)
      throws ModelFormatException, IOException {
    addTextures();
    Model model =
        model(
            """
            {'pbrMetallicRoughness': {%s}, 'extensions': {'KHR_materials_ior': {'ior': 1.4},
             'KHR_materials_pbrSpecularGlossiness': {%s}}}
            """
                .formatted(core, extension));
    ModelMaterial material = model.parts().get(0).material();
    assertThat(material.glossy()).isEqualTo(isGlossy);
    assertThat(material.input(IOR).number()).isEqualTo(isGlossy ? 0 : 1.4);
    String other = "KHR_materials_pbrSpecularGlossiness";
    String warning =
        isGlossy
            ? "materials[0].pbrMetallicRoughness: has no effect beside " + other
            : "materials[0].extensions." + other + ": has no effect beside pbrMetallicRoughness";
    assertThat(model.warnings().contains(warning)).isEqualTo(!core.isEmpty());
  }

  @Test
  void materialsOfConvertersAreThoseOfTheirCore() throws ModelFormatException, IOException {
    addTextures();
    String core =
        "'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}, 'metallicFactor': 0,"
            + " 'roughnessFactor': 0.8}";
    ModelMaterial both =
        material(
            "{"
                + core
                + ", 'extensions': {'KHR_materials_pbrSpecularGlossiness': {'specularFactor':"
                + " [0.9, 0.9, 0.9], 'glossinessFactor': 0.2, 'diffuseTexture': {'index': 0}}}}");
    file.set("materials", "[{" + core + "}]");
    ModelMaterial alone = file.read().parts().get(0).material();
    assertThat(both).usingRecursiveComparison().isEqualTo(alone);
  }

  @Test
  void unlitReplacesSpecularGlossiness() throws ModelFormatException, IOException {
    ModelMaterial material = glossy(", 'KHR_materials_unlit': {}");
    assertThat(material.glossy()).isFalse();
    assertThat(material.unlit()).isTrue();
    assertThat(material.input(BASE_COLOR).factor()).isEqualTo(new Rgb(1, 0, 0));
  }

  @Test
  void extensionsBesideSpecularGlossinessAreLeftOut() throws ModelFormatException, IOException {
    addTextures();
    Model model =
        model(
            """
            {'emissiveFactor': [1, 1, 1], 'extensions': {'KHR_materials_ior': {'ior': 1.4},
              'KHR_materials_emissive_strength': {'emissiveStrength': 3},
              'KHR_materials_pbrSpecularGlossiness': {'glossinessFactor': 1.5}}}
            """);
    ModelMaterial material = model.parts().get(0).material();
    assertThat(material.input(IOR)).isEqualTo(MaterialInput.of(0));
    assertThat(material.emission().factor()).isEqualTo(Rgb.gray(3));
    assertThat(model.warnings())
        .containsExactly(
            "materials[0].extensions.KHR_materials_pbrSpecularGlossiness.glossinessFactor:"
                + " expected 0 to 1, found 1.5; 1 is used",
            "materials[0].extensions.KHR_materials_ior: has no effect beside"
                + " KHR_materials_pbrSpecularGlossiness");
  }

  @Test
  void unlitIsRead() throws ModelFormatException, IOException {
    assertThat(extended("KHR_materials_unlit", "{}").unlit()).isTrue();
  }

  @Test
  void factorsBeyondTheirRangeAreClamped() throws ModelFormatException, IOException {
    Model model = model("{'pbrMetallicRoughness': {'roughnessFactor': 1.5}}");
    assertThat(model.parts().get(0).material().input(ROUGHNESS).number()).isEqualTo(1);
    assertThat(model.warnings())
        .containsExactly(
            "materials[0].pbrMetallicRoughness.roughnessFactor: expected 0 to 1, found 1.5; 1 is"
                + " used");
  }

  private ModelTexture texture(String info) throws ModelFormatException, IOException {
    return material("{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0" + info + "}}}")
        .input(BASE_COLOR)
        .texture()
        .orElseThrow();
  }

  @ParameterizedTest
  @CsvSource({"10497, REPEAT", "33648, MIRROR", "33071, CLAMP"})
  void samplersWrap(int code, Wrap wrap) throws ModelFormatException, IOException {
    addTextures();
    file.set("textures", "[{'source': 0, 'sampler': 0}]");
    file.add("samplers", "{'wrapS': " + code + ", 'magFilter': 9728}");
    ModelTexture texture = texture("");
    assertThat(texture.wrapU()).isEqualTo(wrap);
    assertThat(texture.wrapV()).isEqualTo(Wrap.REPEAT);
    assertThat(texture.nearest()).isTrue();
  }

  @Test
  void texturesRepeatWithoutSampler() throws ModelFormatException, IOException {
    addTextures();
    ModelTexture texture = texture("");
    assertThat(texture.wrapU()).isEqualTo(Wrap.REPEAT);
    assertThat(texture.wrapV()).isEqualTo(Wrap.REPEAT);
    assertThat(texture.nearest()).isFalse();
    assertThat(texture.uvSet()).isZero();
    assertThat(texture.uvTransform()).isEqualTo(UvTransform.IDENTITY);
  }

  /** The examples of the extension, and its formula, in texture coordinates with v downwards. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'offset': [0, 1], 'rotation': 1.57079632679489662, 'scale': [0.5, 0.5] | .5v | 1-.5u",
        "'offset': [0, 1], 'scale': [1, -1] | u | 1-v",
        "'offset': [0.25, 0.5] | u+.25 | v+.5",
        "'scale': [2, 3] | 2u | 3v",
        "'rotation': 1.57079632679489662, 'scale': [2, 3] | 3v | -2u"
      },
      quoteCharacter = '`')
  void texturesAreTransformed(String transform, String u, String v)
      throws ModelFormatException, IOException {
    addTextures();
    UvTransform found =
        texture(", 'extensions': {'KHR_texture_transform': {" + transform + "}}").uvTransform();
    double[][] points = {{0, 0}, {1, 0}, {0, 1}, {.25, .75}};
    for (double[] p : points) {
      assertThat(found.u(p[0], 1 - p[1])).isEqualTo(value(u, p));
      assertThat(1 - found.v(p[0], 1 - p[1])).isEqualTo(value(v, p));
    }
  }

  private static double value(String formula, double[] p) {
    double u = p[0];
    double v = p[1];
    return switch (formula) {
      case ".5v" -> .5 * v;
      case "1-.5u" -> 1 - .5 * u;
      case "u" -> u;
      case "1-v" -> 1 - v;
      case "u+.25" -> u + .25;
      case "v+.5" -> v + .5;
      case "2u" -> 2 * u;
      case "3v" -> 3 * v;
      case "-2u" -> -2 * u;
      default -> throw new AssertionError(formula);
    };
  }

  @Test
  void texturesTransformOverridesTheSet() throws ModelFormatException, IOException {
    addTextures();
    assertThat(texture(", 'extensions': {'KHR_texture_transform': {'texCoord': 1}}").uvSet())
        .isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"'index': 2", "'index': 0, 'texCoord': 2"})
  void unsupportedTexturesAreLeftOut(String info) throws ModelFormatException, IOException {
    addTextures();
    file.add("textures", "{'extensions': {'EXT_texture_avif': {'source': 0}}}");
    Model model = model("{'emissiveTexture': {" + info + "}}");
    assertThat(model.parts().get(0).material().emission().texture()).isEmpty();
    assertThat(model.warnings())
        .containsExactly(
            "materials[0].emissiveTexture: "
                + (info.contains("Coord")
                    ? "TEXCOORD_2 is not supported"
                    : "expected a picture, found EXT_texture_avif")
                + "; the texture is left out");
  }

  private void addVariants() {
    file.triangle(
        """
        , 'material': 0, 'extensions': {'KHR_materials_variants': {'mappings':
          [{'material': 1, 'variants': [0]}, {'material': 2, 'variants': [1, 2]}]}}
        """);
    file.add("nodes", "{'mesh': 0}");
    for (int i = 0; i < 3; i++) {
      file.add("materials", "{'name': 'm" + i + "'}");
    }
    file.set(
        "extensions",
        """
        {'KHR_materials_variants':
          {'variants': [{'name': 'red'}, {'name': 'green'}, {'name': 'blue'}, {'name': 'x'}]}}
        """);
  }

  @ParameterizedTest
  @CsvSource({"'', m0", "red, m1", "green, m2", "blue, m2", "x, m0"})
  void variantsChooseMaterials(String variant, String expected)
      throws ModelFormatException, IOException {
    addVariants();
    Optional<String> wanted = variant.isEmpty() ? Optional.empty() : Optional.of(variant);
    ModelOptions options = new ModelOptions(Optional.empty(), wanted, ModelOptions.Up.Y, 1);
    Model model = file.read(options);
    assertThat(model.variants()).isEqualTo(List.of("red", "green", "blue", "x"));
    assertThat(model.parts().get(0).material().name()).isEqualTo(expected);
  }
}
