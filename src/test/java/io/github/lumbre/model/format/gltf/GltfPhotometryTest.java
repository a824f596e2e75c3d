package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.Sky;
import io.github.lumbre.stage.StagedModel;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/**
 * The units of light in glTF, in pictures: 1 nit of an emissive surface is 1, and candelas and lux
 * make a white surface shine with E / π in the same unit.
 */
class GltfPhotometryTest {
  private static final String WHITE =
      "{'pbrMetallicRoughness': {'metallicFactor': 0},"
          + " 'extensions': {'KHR_materials_specular': {'specularFactor': 0}}}";

  /**
   * Pictures have 24 bits, and pixels lie within 1e-4 of the origin, which changes angles and
   * distances of a few units by less than that; over the pixels, these changes cancel.
   */
  private static final double ERROR = 2e-6;

  /** Returns the radiance of a small surface at the origin, which faces +z, in the picture. */
  private static double radiance(double scale, String material, String light, String place)
      throws Exception {
    GltfFile file = new GltfFile();
    file.triangle(", 'material': 0");
    file.add("materials", material);
    file.add("cameras", "{'type': 'orthographic', 'orthographic': {'xmag': 1e-4, 'ymag': 1e-4}}");
    file.set("extensions", "{'KHR_lights_punctual': {'lights': [" + light + "]}}");
    file.add("nodes", "{'children': [1, 2, 3], 'scale': [%1$s, %1$s, %1$s]}".formatted(scale));
    file.add("nodes", "{'mesh': 0, 'scale': [1e-3, 1e-3, 1e-3], 'translation': [-3e-4, -3e-4, 0]}");
    file.add("nodes", "{'camera': 0, 'translation': [0, 0, 0.1]}");
    file.add("nodes", "{'extensions': {'KHR_lights_punctual': {'light': 0}}, " + place + "}");
    SceneParser parser =
        new SceneParser()
            .overriding(s -> s.toBuilder().size(2, 2).samples(16).threads(1).build());
    Stage dark = Stage.DEFAULT.under(new Sky("white", 0, 0));
    SceneFile scene =
        StagedModel.read("a.glb", file.glb(), ModelFolder.NONE, dark, parser).scene();
    Image image = new PictureRenderer(scene.settings()).render(scene.scene());
    double sum = 0;
    for (float component : image.rgb()) {
      sum += component;
    }
    return sum / image.rgb().length;
  }

  private static String at(double x, double z) {
    return String.format(Locale.ROOT, "'translation': [%s, 0, %s]", x, z);
  }

  private static void assertNear(double found, double expected) {
    assertThat(found).isCloseTo(expected, within(ERROR * expected));
  }

  @Test
  void nitIsOne() throws Exception {
    String emissive =
        "{'emissiveFactor': [1, 1, 1],"
            + " 'extensions': {'KHR_materials_emissive_strength': {'emissiveStrength': 700}},"
            + " 'pbrMetallicRoughness': {'baseColorFactor': [0, 0, 0, 1], 'metallicFactor': 1}}";
    assertNear(radiance(1, emissive, "{'type': 'point', 'intensity': 0}", at(0, 1)), 700);
  }

  @Test
  void candelasFallWithTheSquareOfTheDistance() throws Exception {
    // 800 lm all around.
    double candela = 800 / (4 * Math.PI);
    String bulb = "{'type': 'point', 'intensity': " + candela + "}";
    assertNear(radiance(1, WHITE, bulb, at(0, 2)), candela / 4 / Math.PI);
    assertNear(radiance(1, WHITE, bulb, at(3, 4)), candela / 25 * .8 / Math.PI);
    // A scale of nodes changes distances, and not the light.
    assertNear(radiance(10, WHITE, bulb, at(0, 2)), candela / 400 / Math.PI);
  }

  @Test
  void luxOfTheSunDependsOnTheAngleAlone() throws Exception {
    String sun = "{'type': 'directional', 'intensity': 100000}";
    String tilted = "'rotation': [0.5, 0, 0, 0.8660254037844386]";
    assertNear(radiance(1, WHITE, sun, at(5, 7)), 1e5 / Math.PI);
    assertNear(radiance(10, WHITE, sun, tilted), .5e5 / Math.PI);
  }

  /** The extension leaves the curve between the cones open: here it is a smooth step. */
  @Test
  void candelasOfASpotHoldInsideItsInnerCone() throws Exception {
    String spot =
        "{'type': 'spot', 'intensity': 400,"
            + " 'spot': {'innerConeAngle': 0.2, 'outerConeAngle': 0.5}}";
    double[] angles = {0, .19, .35, .51};
    double[] shares = {1, 1, .5, 0};
    for (int i = 0; i < angles.length; i++) {
      double sine = StrictMath.sin(angles[i]);
      double cosine = StrictMath.cos(angles[i]);
      double found = radiance(1, WHITE, spot, at(2 * sine, 2 * cosine));
      // At half of the step, its slope of 5 per radian adds the rounding of the angles.
      assertThat(found)
          .isCloseTo(400. / 4 * cosine * shares[i] / Math.PI, within(2e-5 * 400 / 4 / Math.PI));
    }
  }
}
