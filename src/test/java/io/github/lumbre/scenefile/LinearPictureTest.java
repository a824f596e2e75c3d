package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.format.exr.ExrBuilder;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.texture.Texture;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of linear light as skies and textures. */
class LinearPictureTest {
  private static final byte[] HEADER = "PF\n1 1\n-1.0\n".getBytes(StandardCharsets.US_ASCII);

  private static SceneFile parse(float r, float g, float b) throws SceneFormatException {
    ByteBuffer pfm = ByteBuffer.allocate(HEADER.length + 12).order(ByteOrder.LITTLE_ENDIAN);
    pfm.put(HEADER).putFloat(r).putFloat(g).putFloat(b);
    String scene =
        """
        {"mainCameraId": 1,
         "assets": [{"id": 2, "assetType": "Texture", "base64PNG": "%s"}],
         "objects": [{"id": 1, "type": "Camera", "cameraType": "Pinhole"},
           {"type": "Light", "lightType": "Dome", "intensity": 1, "textureId": 2}]}
        """
            .formatted(Base64.getEncoder().encodeToString(pfm.array()));
    return new SceneParser().parse(scene.getBytes(StandardCharsets.UTF_8), Path.of("scene.json"));
  }

  private static Rgb sky(SceneFile file) {
    return file.scene().environments().get(0).from(Vec3.Y);
  }

  @Test
  void colorsAreLinearAndMayExceed1() throws SceneFormatException {
    SceneFile file = parse(.25f, 1, 100);
    assertThat(sky(file)).isEqualTo(new Rgb(.25, 1, 100));
    assertThat(file.warnings()).isEmpty();
  }

  @Test
  void negativeColorsCountAs0WithAWarning() throws SceneFormatException {
    SceneFile file = parse(-1e-4f, -3, 2);
    assertThat(sky(file)).isEqualTo(new Rgb(0, 0, 2));
    assertThat(file.warnings())
        .extracting(Problem::toString)
        .containsExactly(
            "scene.json: $.assets[0].base64PNG: has 2 negative colors, which count as 0");
  }

  @Test
  void infiniteColorsAreErrors() {
    for (float wrong : new float[] {Float.NaN, Float.POSITIVE_INFINITY}) {
      assertThatThrownBy(() -> parse(1, wrong, 1))
          .isInstanceOf(SceneFormatException.class)
          .hasMessage(
              "scene.json: $.assets[0].base64PNG: expected finite colors, found "
                  + wrong
                  + " at pixel 0,0");
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
  void theFirstPixelThatIsNotFiniteIsNamedAndMayCountAs0(float wrong) throws Exception {
    byte[] header = "PF\n4 3\n-1\n".getBytes(StandardCharsets.US_ASCII);
    ByteBuffer file = ByteBuffer.allocate(header.length + 144).order(ByteOrder.LITTLE_ENDIAN);
    file.put(header);
    for (int row = 2; row >= 0; row--) {
      for (int i = 0; i < 12; i++) {
        file.putFloat(row == 1 && i == 7 || row == 2 && i == 3 ? wrong : 2);
      }
    }
    byte[] pfm = file.array();
    String text =
        """
        {"mainCameraId": 1,
         "assets": [{"id": 2, "assetType": "Texture", "base64PNG": "%s"}],
         "objects": [{"id": 1, "type": "Camera", "cameraType": "Pinhole"},
           {"type": "Light", "lightType": "Dome", "intensity": 1, "textureId": 2}]}
        """;
    byte[] scene =
        text.formatted(Base64.getEncoder().encodeToString(pfm)).getBytes(StandardCharsets.UTF_8);
    String found = wrong + " at pixel 2,1";
    assertThatThrownBy(() -> new SceneParser().parse(scene, Path.of("s.json")))
        .hasMessage("s.json: $.assets[0].base64PNG: expected finite colors, found " + found);
    SceneFile read = new SceneParser().lenient().parse(scene, Path.of("s.json"));
    assertThat(read.warnings())
        .extracting(Problem::toString)
        .containsExactly(
            "s.json: $.assets[0].base64PNG: has 2 colors that are not finite, which count as 0: "
                + found);
    Texture<Rgb> sky = read.scene().environments().get(0).radiance();
    assertThat(sky.at(2.5 / 4, 1.5 / 3)).isEqualTo(new Rgb(2, 0, 2));
    assertThat(sky.at(.5 / 4, .5 / 3)).isEqualTo(Rgb.gray(2));
  }

  @Test
  void theCaseNamesItsPixel() throws Exception {
    byte[] exr = Files.readAllBytes(Path.of("src/test/resources/cases/e_nan.exr"));
    Image image = LinearReader.decode(exr);
    int first = 0;
    while (!Float.isNaN(image.rgb()[first])) {
      first++;
    }
    String place = first / 3 % image.width() + "," + first / 3 / image.width();
    Stage lit = Stage.DEFAULT.under(new Stage.Sky("src/test/resources/cases/e_nan.exr"));
    Path model = Path.of("src/test/resources/cases/vc.obj");
    assertThatThrownBy(() -> StagedModel.read(model, lit, new SceneParser()))
        .hasMessage("vc.obj: sky: expected finite colors, found NaN at pixel " + place);
    SceneParser lenient = new SceneParser().lenient();
    assertThat(StagedModel.read(model, lit, lenient).scene().warnings()).hasSize(1);
  }

  /** The picture is 0.25 to the left, 0.75 to the right, compressed with DWAB. */
  @Test
  void oneChannelIsGrayInSkiesTexturesAndNormalMaps() throws Exception {
    byte[] exr = ExrBuilder.class.getResourceAsStream("height.exr").readAllBytes();
    String scene =
        """
        {"mainCameraId": 1,
         "assets": [{"id": 2, "assetType": "Texture", "base64PNG": "%s"},
           {"id": 3, "assetType": "Material", "materialType": "Diffuse", "colorTextureId": 2,
            "normalTextureId": 2}],
         "objects": [%s %s {"id": 1, "type": "Camera", "cameraType": "Pinhole"}]}
        """
            .formatted(Base64.getEncoder().encodeToString(exr), SKY, BALL);
    SceneFile file =
        new SceneParser().parse(scene.getBytes(StandardCharsets.UTF_8), Path.of("s.json"));
    NormalMapped bumpy = (NormalMapped) file.scene().primitives().get(0).material();
    Matte matte = (Matte) bumpy.material();
    Texture<Rgb> radiance = file.scene().environments().get(0).radiance();
    for (Texture<Rgb> texture : List.of(radiance, matte.albedo(), bumpy.map().normals())) {
      for (double u : new double[] {.2, .8}) {
        Rgb gray = texture.at(u, .5);
        assertThat(gray).isEqualTo(Rgb.gray(gray.r()));
        assertThat(gray.r()).isCloseTo(u < .5 ? .25 : .75, within(.002));
      }
    }
    assertThat(file.warnings()).isEmpty();
  }

  /** Returns a scene whose sky and only material have an OpenEXR picture of one pixel. */
  private static SceneFile scene(float color, float alpha, String users) throws Exception {
    Path exr = Files.createTempFile("lumbre", ".exr");
    try {
      ImageWriter.write(
          new Image(1, 1, new float[] {color, color, color}, new float[] {alpha}), exr);
      String scene =
          """
          {"mainCameraId": 1,
           "assets": [{"id": 2, "assetType": "Texture", "base64PNG": "%s"},
             {"id": 3, "assetType": "Material", "materialType": "Diffuse", "colorTextureId": 2}],
           "objects": [%s {"id": 1, "type": "Camera", "cameraType": "Pinhole"}]}
          """
              .formatted(Base64.getEncoder().encodeToString(Files.readAllBytes(exr)), users);
      return new SceneParser().parse(scene.getBytes(StandardCharsets.UTF_8), Path.of("scene.json"));
    } finally {
      Files.delete(exr);
    }
  }

  private static final String SKY =
      "{\"type\": \"Light\", \"lightType\": \"Dome\", \"intensity\": 1, \"textureId\": 2},";
  private static final String BALL =
      "{\"type\": \"Shape\", \"shapeType\": \"Sphere\", \"materialID\": 3},";

  /** The writer stores color times alpha, and color where alpha is 0. */
  @ParameterizedTest
  @CsvSource({"1, .25", "0, .25", ".5, .125", "1.25, .3125"})
  void radianceOfASkyIsTheColorInTheFile(float alpha, float stored) throws Exception {
    SceneFile file = scene(.25f, alpha, SKY);
    assertThat(sky(file)).isEqualTo(Rgb.gray(stored));
    assertThat(file.warnings())
        .extracting(Problem::message)
        .noneMatch(message -> message.contains("alpha"));
  }

  @ParameterizedTest
  @CsvSource({"1, .25", "0, .25", ".5, .25", "1.25, .3125"})
  void colorOfASurfaceIsDividedByAlpha(float alpha, float straight) throws Exception {
    SceneFile file = scene(.25f, alpha, SKY + BALL + BALL);
    Matte matte = (Matte) file.scene().primitives().get(0).material();
    assertThat(matte.albedo().at(.5, .5)).isEqualTo(Rgb.gray(straight));
    List<String> warnings =
        file.warnings().stream().map(Problem::message).filter(m -> m.contains("alpha")).toList();
    if (alpha > 1) {
      assertThat(warnings).containsExactly("has alpha outside 0 to 1 in 1 pixel, which is clamped");
    } else {
      assertThat(warnings).isEmpty();
    }
  }
}
