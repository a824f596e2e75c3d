package io.github.lumbre.lab.perf;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import org.junit.jupiter.api.Test;

/** Tests the hash of a picture. */
class RasterHashTest {
  private static final float[] RGB = {.5f, 1, -0f, 3.25f, 1e-3f, 65504};

  /** Another program computed the expected value from the 32 bytes. */
  @Test
  void hashIsThatOfSizeAndLittleEndianFloats() {
    assertThat(RasterHash.of(new Image(2, 1, RGB, new float[0])))
        .isEqualTo("393fbdfe363d7c53de46239452d09454513548f8728501dc7b15c8588202a1ba");
  }

  @Test
  void sizeAndEveryBitCountButAlphaDoesNot() {
    String hash = RasterHash.of(new Image(2, 1, RGB, new float[0]));
    float[] positiveZero = RGB.clone();
    positiveZero[2] = 0;
    assertThat(RasterHash.of(new Image(1, 2, RGB, new float[0]))).isNotEqualTo(hash);
    assertThat(RasterHash.of(new Image(2, 1, positiveZero, new float[0]))).isNotEqualTo(hash);
    assertThat(RasterHash.of(new Image(2, 1, RGB, new float[2]))).isEqualTo(hash);
  }
}
