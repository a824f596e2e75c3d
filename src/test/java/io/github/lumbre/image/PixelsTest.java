package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

/** Tests the order and the size of pixel data. */
class PixelsTest {
  @Test
  void rowsAreCountedFromTheTop() {
    Pixels pixels = Pixels.of(2, 2, 1, new byte[] {1, 2, 3, (byte) 255});
    assertThat(pixels.raw(1, 0, 0)).isEqualTo(2);
    assertThat(pixels.raw(0, 1, 2)).isEqualTo(3);
    assertThat(pixels.value(1, 1, 1)).isEqualTo(1);
  }

  @Test
  void sixteenBitsAreUnsigned() {
    Pixels pixels = Pixels.of(1, 1, 3, new short[] {0, (short) 0x8000, (short) 0xffff});
    assertThat(pixels.max()).isEqualTo(65535);
    assertThat(pixels.raw(0, 0, 1)).isEqualTo(32768);
    assertThat(pixels.value(0, 0, 2)).isEqualTo(1);
  }

  @Test
  void sizesMustFit() {
    assertThatThrownBy(() -> Pixels.of(2, 2, 3, new byte[11]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("values: expected 2x2x3 values, found 11");
    assertThatThrownBy(() -> Pixels.of(0, 2, 3, new byte[0]))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Pixels.of(1, 1, 5, new byte[5]))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void sizesOfSixteenBitsMustFit() {
    assertThatThrownBy(() -> Pixels.of(2, 2, 3, new short[11]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("values: expected 2x2x3 values, found 11");
  }
}
