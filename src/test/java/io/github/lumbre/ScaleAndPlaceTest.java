package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.testing.Effort;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A picture does not depend on the unit of length or on the scene's position in world space. */
class ScaleAndPlaceTest {
  private static final String TETRAHEDRON =
      "v 0 0 0\nv 1 0 0\nv 0 1 .1\nv .2 .1 1\nvn -1 -1 -1\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\n"
          + "f 1//1 3//3 2//2\nf 1//1 2//2 4//4\nf 1//1 4//4 3//3\nf 2//2 3//3 4//4\n";

  /** Every shape and material, and lights without a position. */
  private static final String THINGS =
"""
{'type': 'Shape', 'shapeType': 'Plane', 'materialID': 10},
{'type': 'Shape', 'shapeType': 'Plane', 'finite': true, 'width': 9, 'height': 5,
 'twoSided': true, 'materialID': 11, 'localPosition': {'y': 2, 'z': 4.5},
 'localRotation': {'x': -80, 'y': 10}},
{'type': 'Shape', 'shapeType': 'Sphere', 'radius': 0.8, 'materialID': 12,
 'localPosition': {'x': 0.3, 'y': 0.85, 'z': -1}},
{'type': 'Shape', 'shapeType': 'Sphere', 'radius': 0.5, 'materialID': 13,
 'localPosition': {'x': -1.4, 'y': 0.7, 'z': 0.4}, 'localScale': {'x': 1, 'y': 1.4, 'z': 0.7}},
{'type': 'Shape', 'shapeType': 'Cube', 'width': 1.1, 'materialID': 14,
 'localPosition': {'x': 1.7, 'y': 0.6, 'z': 0.6}, 'localRotation': {'x': 11, 'y': 34}},
{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 20, 'materialID': 15,
 'localPosition': {'x': -0.9, 'y': 0.1, 'z': -1.6}, 'localRotation': {'y': 77}},
{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 21, 'materialID': 10,
 'localPosition': {'x': 1.2, 'y': 0.2, 'z': -1.9}, 'localRotation': {'y': 10, 'z': 50}},
{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 21, 'materialID': 15,
 'localPosition': {'x': -2.1, 'y': 0.2, 'z': 1}, 'localScale': {'x': -1, 'y': 2, 'z': 1.5}},
{'type': 'Light', 'lightType': 'Directional', 'intensity': 0.4, 'localRotation': {'x': 50}},
{'type': 'Light', 'lightType': 'Dome', 'intensity': 0.2, 'textureId': 31}
""";

  private static final String ASSETS =
      """
      {'id': 10, 'assetType': 'Material', 'materialType': 'Diffuse', 'colorTextureId': 30},
      {'id': 11, 'assetType': 'Material', 'materialType': 'Reflective'},
      {'id': 12, 'assetType': 'Material', 'materialType': 'Refractive', 'ior': 1.5},
      {'id': 13, 'assetType': 'Material', 'materialType': 'CookTorrance', 'roughness': 0.3,
       'color': {'r': 0.4, 'g': 0.2, 'b': 0.1}, 'specularColor': {'r': 0.5, 'g': 0.5, 'b': 0.5},
       'normalTextureId': 31},
      {'id': 14, 'assetType': 'Material', 'materialType': 'Refractive', 'ior': 1.3,
       'roughness': 0.2},
      {'id': 15, 'assetType': 'Material', 'materialType': 'Phong', 'exponent': 30,
       'color': {'r': 0.2, 'g': 0.4, 'b': 0.3}, 'specularColor': {'r': 0.3, 'g': 0.3, 'b': 0.3}},
      {'id': 16, 'assetType': 'Material', 'materialType': 'Diffuse',
       'color': {'r': 0.7, 'g': 0.5, 'b': 0.3}},
      {'id': 30, 'assetType': 'Texture', 'textureType': 'Wood', 'width': 64, 'height': 64},
      {'id': 31, 'assetType': 'Texture', 'textureType': 'Voronoi', 'width': 64, 'height': 32,
       'filter': 'bilinear'}\
      """;

  @TempDir Path folder;

  /** Lights with and without parameters that depend on the unit of length. */
  private static String fewLights(double scale) {
    double squared = scale * scale;
    return lamp(0, "radiance", 9)
        + ("{'type': 'Light', 'lightType': 'Point', 'falloff': 'inverseSquare', 'intensity': "
            + 3 * squared
            + ", 'localPosition': {'x': -2, 'y': 3, 'z': -2}},")
        + ("{'type': 'Light', 'lightType': 'Spot', 'penumbra': 9, 'intensity': 0.5,"
            + "'localPosition': {'x': 2, 'y': 3, 'z': -2}, 'localRotation': {'x': 60, 'y': -30}},")
        + ("{'type': 'Light', 'lightType': 'Sphere', 'radius': 0.2, 'unit': 'power', 'intensity': "
            + 5 * squared
            + ", 'localPosition': {'x': -1.5, 'y': 2.5, 'z': 1}}");
  }

  private static String manyLights(double scale) {
    StringBuilder lights = new StringBuilder();
    for (int i = 0; i < 15; i++) {
      lights.append(lamp(i, i % 2 == 0 ? "radiance" : "power", i % 2 == 0 ? 2 : scale * scale));
    }
    return lights + fewLights(scale);
  }

  private static String lamp(int number, String unit, double intensity) {
    return "{'type': 'Light', 'lightType': 'Rectangle', 'width': 0.7, 'height': 0.4, 'unit': '"
        + unit
        + "', 'intensity': "
        + intensity
        + ", 'localRotation': {'x': 90}, 'localPosition': {'y': 3.5, 'x': "
        + (number % 4 - 1.5)
        + ", 'z': "
        + number / 4
        + "}},";
  }

  private static String camera(double scale) {
    return "{'id': 1, 'type': 'Camera', 'cameraType': 'ThinLens', 'fieldOfView': 40, 'aperture': "
        + .1 * scale
        + ", 'focusDistance': "
        + 5 * scale
        + ", 'localPosition': {'x': 0.2, 'y': 1.6, 'z': -6}, 'localRotation': {'x': 8}},";
  }

  private static String scene(String placement, String things) {
    String mesh = "{'id': %d, 'assetType': 'Mesh', 'base64OBJ': '" + base64(TETRAHEDRON) + "'},";
    String text =
        "{'mainCameraId': 1, 'objects': [{"
            + placement
            + ", 'children': ["
            + things
            + "]}], 'assets': ["
            + String.format(Locale.ROOT, mesh, 20)
            + String.format(Locale.ROOT, mesh, 21)
            + ASSETS
            + "]}";
    return text.replace('\'', '"');
  }

  private static String base64(String text) {
    return Base64.getEncoder().encodeToString(text.getBytes(StandardCharsets.US_ASCII));
  }

  private static String scaled(double scale) {
    return "'localScale': {'x': " + scale + ", 'y': " + scale + ", 'z': " + scale + "}";
  }

  private float[] render(String scene, UnaryOperator<RenderSettings.Builder> settings)
      throws IOException, SceneFormatException, InterruptedException {
    Path path = Files.writeString(folder.resolve("scene.json"), scene);
    SceneFile file =
        new SceneParser().overriding(s -> settings.apply(s.toBuilder()).build()).parse(path);
    return new PictureRenderer(file.settings()).render(file.scene()).rgb();
  }

  static int[] exponents() {
    return Effort.isExhaustive()
        ? IntStream.rangeClosed(-30, 30).toArray()
        : new int[] {-30, -17, -1, 8, 30};
  }

  @ParameterizedTest
  @MethodSource("exponents")
  void scalingByAPowerOfTwoChangesNoBit(int exponent)
      throws IOException, SceneFormatException, InterruptedException {
    for (Mode mode : Mode.values()) {
      for (boolean many : new boolean[] {false, true}) {
        float[] large = renderScaled(Math.scalb(1.0, exponent), mode, many);
        assertThat(large).isEqualTo(renderScaled(1, mode, many));
      }
    }
  }

  private float[] renderScaled(double scale, Mode mode, boolean many)
      throws IOException, SceneFormatException, InterruptedException {
    String lights = many ? manyLights(scale) : fewLights(scale);
    return render(
        scene(scaled(scale), camera(scale) + THINGS + "," + lights),
        s ->
            s.mode(mode)
                .size(32, 24)
                .samples(1)
                .seed(Effort.seed(1))
                .maxTraceDepth(8)
                .rayDepths(8, 8));
  }

  /**
   * Inside objects, pixels agree to the ulp of the distance relative to the object size (1e-6 at
   * 1e8) and to float precision. Silhouettes move by a few ulp of the distance, 1e-5 pixels.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e3, 1e6, 1e8})
  void movingTheWorldChangesPixelsByItsUlpAlone(double distance)
      throws IOException, SceneFormatException, InterruptedException {
    String there =
        String.format(
            Locale.ROOT,
            "'localPosition': {'x': %s, 'y': %s, 'z': %s}",
            distance,
            -.7 * distance,
            .9 * distance);
    float[] moved = renderMatte(there);
    float[] here = renderMatte(scaled(1));
    int different = 0;
    for (int i = 0; i < here.length; i++) {
      double bound = here[i] * (1e-6 * distance / 1e8 + 0x1p-23);
      different += Math.abs(here[i] - moved[i]) <= bound ? 0 : 1;
    }
    assertThat(different).isLessThanOrEqualTo(here.length / 1000);
  }

  private float[] renderMatte(String placement)
      throws IOException, SceneFormatException, InterruptedException {
    String seen =
        "{'id': 1, 'type': 'Camera', 'fieldOfView': 40, 'localRotation': {'x': 8},"
            + " 'localPosition': {'x': 0.2, 'y': 1.6, 'z': -6}},";
    String matte = THINGS.replaceAll("'materialID': 1.", "'materialID': 16");
    return render(
        scene(placement, seen + matte + "," + fewLights(1)),
        s ->
            s.mode(Mode.PATH)
                .size(48, 32)
                .samples(Effort.count(64, 1024))
                .seed(Effort.seed(1))
                .maxTraceDepth(1));
  }
}
