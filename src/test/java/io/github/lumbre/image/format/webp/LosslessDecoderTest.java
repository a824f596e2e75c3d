package io.github.lumbre.image.format.webp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageFormatException.Kind;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests lossless pictures that no encoder writes. */
class LosslessDecoderTest {
  private static final int NONE = 0;

  /** Returns the beginning of a picture without transforms and without a cache. */
  private static LosslessWriter plain(int width, int height) {
    return new LosslessWriter(width, height).number(NONE, 1).number(NONE, 1);
  }

  private static void assertMalformed(LosslessWriter file, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file.file()))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(Kind.MALFORMED))
        .hasMessage(message);
  }

  @Test
  void pixelsOfOneColorTakeNoData() throws ImageFormatException {
    Pixels pixels = ImageReader.decode(plain(2000, 3000).number(0, 1).codes(9).file());
    assertThat(pixels.raw(1999, 2999, 1)).isEqualTo(9);
    assertThat(pixels.raw(1999, 2999, 0)).isZero();
    assertThat(pixels.alpha(0, 0)).isEqualTo(255);
  }

  @Test
  void longCodesAreRead() throws ImageFormatException {
    LosslessWriter file = plain(2, 1).number(0, 1).fullCode().code(0).code(0).code(0).code(0);
    Pixels pixels = ImageReader.decode(file.number(0b10000000, 8).number(0b11111111, 8).file());
    assertThat(pixels.raw(0, 0, 1)).isEqualTo(1);
    assertThat(pixels.raw(1, 0, 1)).isEqualTo(255);
  }

  /** Returns a picture whose blocks of 4 x 4 pixels have groups of codes of their own. */
  private static LosslessWriter grouped(int columns, int rows) {
    LosslessWriter file = plain(4 * columns, 4 * rows).number(1, 1).number(0, 3).number(NONE, 1);
    return file.fullCode().fullCode().code(0).code(0).code(0);
  }

  /** The codes of 65,536 groups are read, and one group is used. */
  @Test
  void unusedGroupsTakeNoMemory() throws ImageFormatException {
    LosslessWriter file = grouped(1, 1).number(255, 8).number(255, 8);
    for (int i = 0; i < 1 << 16; i++) {
      file.codes(i == 0xffff ? 3 : 0);
    }
    assertThat(ImageReader.decode(file.file()).raw(3, 3, 1)).isEqualTo(3);
  }

  @ParameterizedTest
  @CsvSource({"1000, false", "4000, true"})
  void groupsMayNotTakeMoreMemoryThanExpected(int groups, boolean isRefused)
      throws ImageFormatException {
    LosslessWriter file = grouped(groups / 10, 10);
    for (int i = 0; i < groups; i++) {
      // The highest bit of a symbol comes first.
      file.number(Integer.reverse(i) >>> 24, 8).number(Integer.reverse(i >> 8) >>> 24, 8);
    }
    for (int i = 0; i < groups; i++) {
      file.fullCode().fullCode().fullCode().fullCode().code(0);
    }
    byte[] bytes = file.number(0, 8 * 16).file();
    String message = isRefused ? "prefix codes that take more memory" : "WebP is truncated";
    assertThatThrownBy(() -> ImageReader.decode(bytes)).hasMessageContaining(message);
  }

  @Test
  void damagedPartsAreNamed() {
    LosslessWriter twice = new LosslessWriter(1, 1).number(0b101, 3).number(0b101, 3);
    assertMalformed(twice, "WebP is damaged: a transform occurs twice");
    LosslessWriter distance = plain(1, 1).number(0, 1).code(0).code(0).code(0).code(0).code(40);
    assertMalformed(distance, "WebP is damaged: a prefix code has an unknown symbol");
    LosslessWriter empty = plain(1, 1).number(0, 1).number(0, 1).number(0, 4).number(0, 12);
    assertMalformed(empty, "WebP is damaged: a prefix code is not complete");
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 12, 15})
  void cachesOfOtherSizesAreRefused(int bits) {
    assertMalformed(
        new LosslessWriter(1, 1).number(0, 1).number(1, 1).number(bits, 4),
        "WebP has a cache of 2^" + bits + " colors, expected 2^1 to 2^11");
  }
}
