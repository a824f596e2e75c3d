package io.github.lumbre.parser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import org.junit.jupiter.api.Test;

/** Pictures of linear light as skies. */
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
          .hasMessage("scene.json: $.assets[0].base64PNG: expected finite colors, found " + wrong);
    }
  }
}
