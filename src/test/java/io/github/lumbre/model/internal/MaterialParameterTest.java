package io.github.lumbre.model.internal;

import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.Channel;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.MaterialParameter.Kind;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.SceneWriter;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.TexturePoint;
import io.github.lumbre.texture.internal.ImageTexture;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each parameter of materials passes each reader and the writer, and changes how light scatters.
 */
class MaterialParameterTest {
  private static final int[] TEXEL = {51, 102, 153, 204};
  private static final Pixels PIXELS =
      Pixels.of(1, 1, 4, new byte[] {51, 102, (byte) 153, (byte) 204});
  private static final Rgb COLOR = new Rgb(.25, .5, .75);
  private static final SurfaceHit HIT =
      new SurfaceHit().set(Vec3.ZERO, Vec3.Z, Frame.WORLD, new TexturePoint(.5, .5), Vec3.Z, 0);

  /**
   * The members of a material by which glTF 2.0 and the texts of its extensions state a parameter:
   * its key in scenes, the object, and the members of the object.
   */
  private static final String IN_GLTF =
      """
      baseColor pbrMetallicRoughness 'baseColorFactor': [C, 1], 'baseColorTexture': T
      opacity pbrMetallicRoughness 'baseColorFactor': [1, 1, 1, 0.25], 'baseColorTexture': T
      metallic pbrMetallicRoughness 'metallicFactor': 0.25, 'metallicRoughnessTexture': T
      roughness pbrMetallicRoughness 'roughnessFactor': 0.25, 'metallicRoughnessTexture': T
      ior KHR_materials_ior 'ior': 1.4
      specular KHR_materials_specular 'specularFactor': 0.25, 'specularTexture': T
      specularColor KHR_materials_specular 'specularColorFactor': [C], 'specularColorTexture': T
      transmission KHR_materials_transmission 'transmissionFactor': 0.25, 'transmissionTexture': T
      diffuseTransmission KHR_materials_diffuse_transmission \
      'diffuseTransmissionFactor': 0.25, 'diffuseTransmissionTexture': T
      diffuseTransmissionColor KHR_materials_diffuse_transmission \
      'diffuseTransmissionColorFactor': [C], 'diffuseTransmissionColorTexture': T
      attenuationColor KHR_materials_volume 'thicknessFactor': 1, 'attenuationColor': [C]
      attenuationDistance KHR_materials_volume 'thicknessFactor': 1, 'attenuationDistance': 0.25
      dispersion KHR_materials_dispersion 'dispersion': 0.25
      clearcoat KHR_materials_clearcoat 'clearcoatFactor': 0.25, 'clearcoatTexture': T
      clearcoatRoughness KHR_materials_clearcoat \
      'clearcoatRoughnessFactor': 0.25, 'clearcoatRoughnessTexture': T
      clearcoatNormal KHR_materials_clearcoat 'clearcoatNormalTexture': {'index': 0, 'scale': 0.25}
      sheenColor KHR_materials_sheen 'sheenColorFactor': [C], 'sheenColorTexture': T
      sheenRoughness KHR_materials_sheen 'sheenRoughnessFactor': 0.25, 'sheenRoughnessTexture': T
      anisotropy KHR_materials_anisotropy 'anisotropyStrength': 0.25, 'anisotropyTexture': T
      anisotropyRotation KHR_materials_anisotropy 'anisotropyRotation': 0.25
      anisotropyDirection KHR_materials_anisotropy 'anisotropyTexture': {'index': 0, 'scale': 0.25}
      iridescence KHR_materials_iridescence 'iridescenceFactor': 0.25, 'iridescenceTexture': T
      iridescenceIor KHR_materials_iridescence 'iridescenceIor': 1.4
      iridescenceThicknessMinimum KHR_materials_iridescence 'iridescenceThicknessMinimum': 0.25
      iridescenceThicknessMaximum KHR_materials_iridescence 'iridescenceThicknessMaximum': 0.25
      iridescenceThickness KHR_materials_iridescence 'iridescenceThicknessTexture': T
      """;

  static List<MaterialParameter> all() {
    return MaterialParameter.all();
  }

  static Stream<MaterialParameter> inScenes() {
    return all().stream().filter(p -> !p.key().isEmpty());
  }

  static Stream<MaterialParameter> inLibraries() {
    return all().stream().filter(p -> !p.mtl().isEmpty());
  }

  /** Returns a value of a parameter that is not its default. */
  private static double number(MaterialParameter parameter) {
    return Math.max(.25, 1.4 * parameter.least());
  }

  private static Rgb factor(MaterialParameter parameter) {
    return parameter.kind() == Kind.COLOR ? COLOR : Rgb.gray(number(parameter));
  }

  private static Rgb texel(ImageTexture.Role role) {
    return new ImageTexture(PIXELS, role, ImageTexture.Filter.NEAREST).at(.5, .5);
  }

  private static NormalChannel normals(double strength) {
    Rgb normal = texel(ImageTexture.Role.NORMAL);
    return new NormalChannel(new NormalMap((u, v) -> normal, strength), 0);
  }

  private static void assertValue(Channel found, Rgb expected) {
    if (found instanceof ColorChannel color) {
      assertNear(color.at(HIT), expected, 1e-7);
    } else if (found instanceof ScalarChannel number) {
      assertThat(number.at(HIT)).isCloseTo(expected.r(), within(1e-9));
    } else {
      NormalMap map = ((NormalChannel) found).map();
      assertThat(map.normal(.5, .5)).isEqualTo(normals(expected.r()).map().normal(.5, .5));
    }
  }

  /** Returns a material of metal, plastic and rough glass, with all layers. */
  private static MetallicRoughness.Builder everything() {
    MetallicRoughness.Builder builder = MetallicRoughness.builder();
    for (MaterialParameter parameter : all()) {
      boolean isLayer =
          parameter.defaultValue().isBlack() || parameter == MaterialParameter.METALLIC;
      if (parameter.kind() == Kind.COLOR && parameter != MaterialParameter.ATTENUATION_COLOR) {
        builder.set(parameter, Rgb.gray(.5));
      } else if (parameter.kind() == Kind.NUMBER && isLayer) {
        // Not .6: such a coat has the index of the thin film, which is then invisible.
        builder.set(parameter, .55);
      }
    }
    return builder.set(MaterialParameter.ROUGHNESS, .6);
  }

  /** Returns what a material does at the hit, as text. */
  private static String effect(MetallicRoughness.Builder builder) {
    MetallicRoughness material = builder.build();
    Bsdf bsdf = material.at(HIT);
    Vec3 wo = new Vec3(.3, .1, 1).normalized();
    List<Object> all = new ArrayList<>(List.of(material.transmittance(HIT), material.absorption()));
    for (double z : new double[] {.9, .3, -.5}) {
      all.add(bsdf.evaluate(wo, new Vec3(-.4, .2, z).normalized()).f());
    }
    return all.toString();
  }

  @ParameterizedTest
  @MethodSource("all")
  void parametersChangeHowLightScatters(MaterialParameter parameter) {
    MetallicRoughness.Builder material = everything();
    if (parameter == MaterialParameter.ATTENUATION_COLOR) {
      material.set(MaterialParameter.ATTENUATION_DISTANCE, 2);
    } else if (parameter == MaterialParameter.ATTENUATION_DISTANCE) {
      material.set(MaterialParameter.ATTENUATION_COLOR, COLOR);
    } else if (parameter == MaterialParameter.DISPERSION) {
      material.set(MaterialParameter.ATTENUATION_DISTANCE, 2);
    } else if (parameter == MaterialParameter.IRIDESCENCE_THICKNESS_MINIMUM) {
      material.set(MaterialParameter.IRIDESCENCE_THICKNESS, .5);
    }
    String before = effect(material);
    switch (parameter.kind()) {
      case COLOR -> material.set(parameter, COLOR);
      case NUMBER -> material.set(parameter, number(parameter));
      case NORMALS -> material.set(parameter, normals(1));
    }
    assertThat(effect(material)).isNotEqualTo(before);
  }

  private static JsonObject gltf(MaterialParameter parameter) {
    JsonObject extensions = new JsonObject();
    JsonObject material = new JsonObject();
    for (MaterialParameter each : List.of(parameter.strengths().get(0), parameter)) {
      String line = IN_GLTF.lines().filter(l -> l.startsWith(each + " ")).findAny().orElseThrow();
      String[] text = line.split(" ", 3);
      String members = text[2].replace("[C", "[0.25, 0.5, 0.75").replace(": T", ": {'index': 0}");
      JsonObject stated = JsonParser.parseString("{" + members + "}").getAsJsonObject();
      JsonObject parent = text[1].equals("pbrMetallicRoughness") ? material : extensions;
      JsonObject known = parent.getAsJsonObject(text[1]);
      parent.add(text[1], known == null ? stated : known);
      stated.asMap().forEach(parent.getAsJsonObject(text[1])::add);
    }
    material.add("extensions", extensions);
    material.addProperty("alphaMode", "BLEND");
    return material;
  }

  @ParameterizedTest
  @MethodSource("all")
  void gltfIsRead(MaterialParameter parameter) throws Exception {
    GltfFile file = new GltfFile();
    file.add("nodes", "{'mesh': " + file.triangle(", 'material': 0") + "}");
    file.add(
        "images", "{'mimeType': 'image/png', 'bufferView': " + file.view(PIXELS.toPng(), "") + "}");
    file.add("textures", "{'source': 0}");
    file.add("materials", gltf(parameter).toString().replace('"', '\''));
    file.add("extensionsUsed", "'KHR_materials_volume'");
    Model model = file.read();
    assertThat(model.warnings()).isEmpty();
    ModelMaterial read = model.parts().get(0).material();
    assertThat(read.uses(parameter)).isTrue();
    MetallicRoughness material =
        (MetallicRoughness)
            new ModelMaterials(Transform.IDENTITY, Limits.NONE, new DecodedPictures())
                .of(read, true);
    boolean hasFactor = !parameter.gltfFactor().isEmpty() || parameter.kind() == Kind.NORMALS;
    Rgb expected = (hasFactor ? factor(parameter) : Rgb.WHITE).times(parameter.gltfUnit());
    if (parameter.kind() == Kind.COLOR && parameter.isTextured()) {
      expected = expected.times(texel(ImageTexture.Role.COLOR));
    } else if (parameter.kind() == Kind.NUMBER && parameter.isTextured()) {
      expected = expected.times(TEXEL[parameter.gltfChannel()] / 255.);
    }
    assertValue(material.stated(parameter).orElseThrow(), expected);
  }

  @ParameterizedTest
  @MethodSource("inLibraries")
  void librariesAreRead(MaterialParameter parameter) throws Exception {
    String key = parameter.mtl();
    for (String statement : new String[] {key + " .25", "map_" + key + " -imfchan b a.png"}) {
      ModelFixture file =
          new ModelFixture("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n")
              .with("a.mtl", "newmtl m\nPc 1\nPs 1\n" + statement)
              .with("a.png", PIXELS.toPng());
      assertThat(file.read().warnings()).isEmpty();
      boolean isMap = statement.startsWith("map");
      MetallicRoughness material =
          (MetallicRoughness)
              new ModelMaterials(Transform.IDENTITY, Limits.NONE, new DecodedPictures())
                  .of(file.part().material(), true);
      Rgb texel =
          parameter.kind() == Kind.COLOR
              ? texel(ImageTexture.Role.COLOR)
              : Rgb.gray(TEXEL[2] / 255.);
      assertValue(material.stated(parameter).orElseThrow(), isMap ? texel : Rgb.gray(.25));
    }
  }

  private static String color(Rgb value) {
    return "{\"r\": %s, \"g\": %s, \"b\": %s}".formatted(value.r(), value.g(), value.b());
  }

  private static String scene(MaterialParameter parameter) {
    String stem = "\"" + parameter.key();
    String value = parameter.kind() == Kind.COLOR ? color(COLOR) : "" + number(parameter);
    String stated = stem + (parameter.kind() == Kind.NORMALS ? "Strength" : "") + "\": " + value;
    if (parameter.isTextured()) {
      stated += ", " + stem + "TextureId\": 3";
    }
    return """
    {"mainCameraId": 1, "objects": [{"type": "Camera", "id": 1},
      {"type": "Shape", "shapeType": "Sphere", "materialID": 2}], "assets": [
      {"id": 2, "assetType": "Material", "materialType": "MetallicRoughness", %s},
      {"id": 3, "assetType": "Texture", "base64PNG": "%s"}]}
    """
        .formatted(stated, Base64.getEncoder().encodeToString(PIXELS.toPng()));
  }

  @ParameterizedTest
  @MethodSource("inScenes")
  void scenesAreReadAndWritten(MaterialParameter parameter) throws Exception {
    byte[] json = scene(parameter).getBytes(StandardCharsets.UTF_8);
    SceneFile file = new SceneParser().parse(json, Path.of("a.json"));
    assertThat(file.warnings()).isEmpty();
    SceneFile written =
        SceneWriter.file(
            Scene.builder()
                .lookingAt(new Vec3(0, 0, -5), Vec3.ZERO, 50)
                .add(Sphere.of(Vec3.ZERO, 1), file.scene().primitives().get(0).material())
                .build(),
            file.settings());
    Rgb expected = factor(parameter);
    if (parameter.kind() == Kind.COLOR && parameter.isTextured()) {
      expected = expected.times(texel(ImageTexture.Role.COLOR));
    } else if (parameter.kind() == Kind.NUMBER && parameter.isTextured()) {
      expected = expected.times(TEXEL[0] / 255.);
    }
    for (SceneFile each : List.of(file, written)) {
      MetallicRoughness material = (MetallicRoughness) each.scene().primitives().get(0).material();
      assertValue(material.stated(parameter).orElseThrow(), expected);
    }
  }
}
