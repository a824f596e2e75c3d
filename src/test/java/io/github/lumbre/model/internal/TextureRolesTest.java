package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.Sky;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.testing.Pictures;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each texture of a glTF material obeys its set of texture coordinates, KHR_texture_transform and
 * vertex colors: the picture is that of a model with its coordinates and colors worked in.
 */
class TextureRolesTest {
  private static final String FACTOR = "'baseColorFactor': [COLOR], 'metallicFactor': 0";
  private static final String TEXTURE = "'baseColorTexture': T";
  private static final String UNLIT = ", 'extensions': {'KHR_materials_unlit': {}}";
  private static final String SHINY = ", 'roughnessFactor': 0.3";

  /** The textures; in their materials, T stands for the texture and COLOR for the base color. */
  private enum Role {
    BASE_COLOR("", TEXTURE),
    MASK(", 'alphaMode': 'MASK', 'alphaCutoff': 0.3", TEXTURE),
    BLEND(", 'alphaMode': 'BLEND'", TEXTURE),
    METALLIC_ROUGHNESS("", "'metallicFactor': 1, 'metallicRoughnessTexture': T"),
    NORMAL(", 'normalTexture': T" + SHINY, ""),
    EMISSION(", 'emissiveFactor': [1, 0.5, 0.25], 'emissiveTexture': T", ""),
    EMISSION_MASK(
        ", 'emissiveFactor': [1, 1, 1], 'alphaMode': 'MASK', 'alphaCutoff': 0.3", TEXTURE),
    EMISSION_BLEND(", 'emissiveFactor': [1, 1, 1], 'alphaMode': 'BLEND'", TEXTURE),
    UNLIT_COLOR(UNLIT, TEXTURE),
    UNLIT_MASK(UNLIT + ", 'alphaMode': 'MASK', 'alphaCutoff': 0.3", TEXTURE),
    UNLIT_BLEND(UNLIT + ", 'alphaMode': 'BLEND'", TEXTURE),
    SPECULAR("specular", "'specularTexture': T", true),
    SPECULAR_COLOR("specular", "'specularColorFactor': [9, 9, 9], 'specularColorTexture': T", true),
    TRANSMISSION("transmission", "'transmissionFactor': 1, 'transmissionTexture': T", true),
    DIFFUSE_TRANSMISSION(
        "diffuse_transmission",
        "'diffuseTransmissionFactor': 1, 'diffuseTransmissionTexture': T",
        true),
    DIFFUSE_TRANSMISSION_COLOR(
        "diffuse_transmission",
        "'diffuseTransmissionFactor': 0.5, 'diffuseTransmissionColorTexture': T",
        true),
    CLEARCOAT("clearcoat", "'clearcoatFactor': 1, 'clearcoatTexture': T", true),
    CLEARCOAT_ROUGHNESS(
        "clearcoat",
        "'clearcoatFactor': 1, 'clearcoatRoughnessFactor': 1, 'clearcoatRoughnessTexture': T",
        true),
    CLEARCOAT_NORMAL("clearcoat", "'clearcoatFactor': 1, 'clearcoatNormalTexture': T", true),
    SHEEN_COLOR(
        "sheen",
        "'sheenColorFactor': [1, 1, 1], 'sheenRoughnessFactor': 1, 'sheenColorTexture': T",
        true),
    SHEEN_ROUGHNESS(
        "sheen",
        "'sheenColorFactor': [1, 1, 1], 'sheenRoughnessFactor': 1, 'sheenRoughnessTexture': T",
        true),
    ANISOTROPY("anisotropy", "'anisotropyStrength': 1, 'anisotropyTexture': T", true),
    IRIDESCENCE(
        "iridescence",
        "'iridescenceFactor': 1, 'iridescenceIor': 2, 'iridescenceTexture': T",
        true),
    IRIDESCENCE_THICKNESS(
        "iridescence",
        "'iridescenceFactor': 1, 'iridescenceIor': 2, 'iridescenceThicknessTexture': T",
        true),
    DIFFUSE(glossy("", "'specularFactor': [0.2, 0.1, 0.3], 'diffuseTexture': T")),
    DIFFUSE_MASK(
        glossy(
            ", 'alphaMode': 'MASK', 'alphaCutoff': 0.3",
            "'specularFactor': [0, 0, 0], 'diffuseTexture': T")),
    DIFFUSE_BLEND(
        glossy(", 'alphaMode': 'BLEND'", "'specularFactor': [0, 0, 0], 'diffuseTexture': T")),
    SPECULAR_GLOSSINESS(glossy("", "'specularGlossinessTexture': T"));

    private final String material;

    Role(String more, String metallicRoughness) {
      boolean statesMetal = metallicRoughness.contains("metallicFactor");
      String factor = statesMetal ? "'baseColorFactor': [COLOR]" : FACTOR;
      boolean isShiny = more.endsWith(SHINY);
      material =
          "{'pbrMetallicRoughness': {%s%s%s}%s}"
              .formatted(
                  factor,
                  metallicRoughness.isEmpty() ? "" : ", " + metallicRoughness,
                  isShiny ? SHINY : "",
                  isShiny ? more.replace(SHINY, "") : more);
    }

    Role(String extension, String json, boolean isExtension) {
      material =
          "{'pbrMetallicRoughness': {%s, 'roughnessFactor': 0.3}, ".formatted(FACTOR)
              + "'extensions': {'KHR_materials_%s': {%s}}}".formatted(extension, json);
    }

    Role(String material) {
      this.material = material;
    }

    private static String glossy(String more, String specularGlossiness) {
      return "{'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [COLOR], %s}}%s}"
          .formatted(specularGlossiness, more);
    }
  }

  /**
   * The coordinates of the corners in the reference, which are those of the picture. All numbers
   * are exact. The only lights are directional, so that samples of equal surfaces are equal.
   */
  private static final double[] PLACE = {.125, .75, .875, .6875, .8125, .125, .1875, .3125};

  /** Other coordinates, mirrored, which no texture may use. */
  private static final double[] DECOY = {.9, .2, .2, .1, .15, .85, .75, .9};

  private static final double[] WHITE = {1, 1, 1, 1};
  private static final double[] COLOR = {.5, .25, .75, .5};

  private static final String INFO = "{'index': 0}";

  /** A transform that turns by 90 degrees counterclockwise, mirrors and moves. */
  private static final String TRANSFORM =
      "'extensions': {'KHR_texture_transform': {'offset': [0.25, -0.5], 'scale': [-2, 0.5],"
          + " 'rotation': 1.5707963267948966}}";

  /** Returns (u, v) such that {@link #TRANSFORM} maps it to (x, y): x = .25 + v/2, y = -.5 + 2u. */
  private static double[] before(double... coordinates) {
    double[] before = new double[coordinates.length];
    for (int i = 0; i < before.length; i += 2) {
      before[i] = (coordinates[i + 1] + .5) / 2;
      before[i + 1] = 2 * (coordinates[i] - .25);
    }
    return before;
  }

  private record Mesh(boolean hasNormals, double[] uv0, double[] uv1, Optional<double[]> color) {}

  private static byte[] texture() throws Exception {
    BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_ARGB);
    Random random = new Random(7);
    for (int i = 0; i < 64; i++) {
      image.setRGB(i % 8, i / 8, random.nextInt() | 0x80 | (random.nextInt(4) + 1) << 30);
    }
    return Pictures.file(image, "png");
  }

  private static double[] picture(Role role, String info, double[] factor, Mesh mesh)
      throws Exception {
    GltfFile file = new GltfFile();
    String color = "%s, %s, %s, %s".formatted(factor[0], factor[1], factor[2], factor[3]);
    file.add("materials", role.material.replace("COLOR", color).replace(": T", ": " + info));
    int view = file.view(texture(), "");
    file.add("images", "{'mimeType': 'image/png', 'bufferView': %d}".formatted(view));
    file.add("textures", "{'source': 0}");
    List<String> attributes = new ArrayList<>();
    attributes.add("'POSITION': " + file.floats("VEC3", -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0));
    if (mesh.hasNormals) {
      attributes.add("'NORMAL': " + file.floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1));
    }
    attributes.add("'TEXCOORD_0': " + file.floats("VEC2", mesh.uv0));
    attributes.add("'TEXCOORD_1': " + file.floats("VEC2", mesh.uv1));
    mesh.color.ifPresent(c -> attributes.add("'COLOR_0': " + file.floats("VEC4", fourTimes(c))));
    String corners = ", 'material': 0, 'indices': " + file.ints("SCALAR", 0, 1, 2, 0, 2, 3);
    file.add("nodes", "{'mesh': %d}".formatted(file.mesh(String.join(", ", attributes), corners)));
    file.set(
        "extensions",
        "{'KHR_lights_punctual': {'lights': [{'type': 'directional', 'intensity': 2}]}}");
    for (String fromFrontAndBack : new String[] {"-0.4, 0.3, 0, 0.8660254", "0, 0.8, 0, 0.6"}) {
      file.add(
          "nodes",
          "{'rotation': ["
              + fromFrontAndBack
              + "],"
              + " 'extensions': {'KHR_lights_punctual': {'light': 0}}}");
    }
    Stage stage = Stage.DEFAULT.seenFrom(View.of("front")).under(new Sky("white", 0, 0));
    SceneParser parser =
        new SceneParser()
            .overriding(s -> s.toBuilder().size(10, 10).samples(4).threads(1).build());
    SceneFile scene =
        StagedModel.read("a.glb", file.glb(), ModelFolder.NONE, stage, parser).scene();
    Image image = new PictureRenderer(scene.settings()).render(scene.scene());
    float[] rgb = image.rgb();
    double[] result = new double[rgb.length];
    for (int i = 0; i < rgb.length; i++) {
      result[i] = rgb[i];
    }
    return result;
  }

  private static double[] fourTimes(double... color) {
    double[] all = new double[4 * color.length];
    for (int i = 0; i < all.length; i++) {
      all[i] = color[i % color.length];
    }
    return all;
  }

  private static double difference(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += Math.abs(a[i] - b[i]) / a.length;
    }
    return sum;
  }

  static Stream<Arguments> cases() {
    return Stream.of(Role.values())
        .flatMap(role -> Stream.of(true, false).map(normals -> Arguments.of(role, normals)));
  }

  @ParameterizedTest
  @MethodSource("cases")
  void texturesUseTheirCoordinates(Role role, boolean hasNormals) throws Exception {
    Mesh plain = new Mesh(hasNormals, PLACE, PLACE, Optional.empty());
    double[] expected = picture(role, INFO, WHITE, plain);
    Mesh wrong = new Mesh(hasNormals, DECOY, DECOY, Optional.empty());
    assertThat(difference(picture(role, INFO, WHITE, wrong), expected)).isGreaterThan(1e-3);
    Map<String, double[]> sets = Map.of("", PLACE, ", " + TRANSFORM, before(PLACE));
    for (Map.Entry<String, double[]> each : sets.entrySet()) {
      for (int set = 0; set < 2; set++) {
        double[] own = each.getValue();
        Mesh mesh =
            new Mesh(hasNormals, set == 0 ? own : DECOY, set == 0 ? DECOY : own, Optional.empty());
        String info = "{'index': 0, 'texCoord': %d%s}".formatted(set, each.getKey());
        assertThat(difference(picture(role, info, WHITE, mesh), expected))
            .as(info)
            .isCloseTo(0, within(1e-7));
      }
    }
  }

  /** COLOR_0 multiplies the base color and its alpha, and nothing else. */
  @ParameterizedTest
  @EnumSource(Role.class)
  void vertexColorsMultiplyTheBaseColor(Role role) throws Exception {
    Mesh plain = new Mesh(true, PLACE, DECOY, Optional.empty());
    Mesh colored = new Mesh(true, PLACE, DECOY, Optional.of(COLOR));
    double[] expected = picture(role, INFO, COLOR, plain);
    assertThat(difference(picture(role, INFO, WHITE, plain), expected)).isGreaterThan(1e-3);
    assertThat(difference(picture(role, INFO, WHITE, colored), expected))
        .isCloseTo(0, within(1e-7));
  }
}
