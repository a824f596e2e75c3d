package io.github.lumbre.image.format.png;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import java.nio.ByteBuffer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** PNG files whose transparency is that of colors have the alpha of files with a channel for it. */
class PngTransparencyTest {
  private static final int WIDTH = 9;
  private static final int HEIGHT = 7;

  /** All color types without alpha, with their bit depths. */
  static Stream<Arguments> forms() {
    int[][] forms = {
      {PngFixture.GRAY, 1}, {PngFixture.GRAY, 2}, {PngFixture.GRAY, 4}, {PngFixture.GRAY, 8},
      {PngFixture.GRAY, 16}, {PngFixture.RGB, 8}, {PngFixture.RGB, 16}, {PngFixture.PALETTE, 1},
      {PngFixture.PALETTE, 2}, {PngFixture.PALETTE, 4}, {PngFixture.PALETTE, 8}
    };
    return Stream.of(forms)
        .flatMap(
            form ->
                Stream.of(
                    Arguments.of(form[0], form[1], false), Arguments.of(form[0], form[1], true)));
  }

  /** Returns a sample of few different values, also large ones. */
  private static int sample(int column, int row, int depth) {
    int value = (column * column + 3 * row) % 5;
    return (depth < 8 ? value : value * 0x3b31) & (1 << depth) - 1;
  }

  private static byte[] transparency(int type, int depth) {
    if (type == PngFixture.PALETTE) {
      return depth == 1 ? new byte[] {0} : new byte[] {0, (byte) 128, (byte) 255};
    }
    int channels = PngFixture.channels(type);
    ByteBuffer data = ByteBuffer.allocate(2 * channels);
    for (int c = 0; c < channels; c++) {
      data.putShort((short) sample(channels * 2 + c, 3, depth));
    }
    return data.array();
  }

  private static byte[] file(int type, int depth, boolean interlaced, byte[] transparency) {
    PngFixture file = new PngFixture().header(WIDTH, HEIGHT, depth, type, interlaced);
    if (type == PngFixture.PALETTE) {
      file.chunk("PLTE", new byte[3 << depth]);
    }
    return file.chunk("tRNS", transparency)
        .data(WIDTH, HEIGHT, depth, type, interlaced, (x, y) -> sample(x, y, depth))
        .end();
  }

  private static int alpha(int type, int depth, int x, int y) {
    int channels = PngFixture.channels(type);
    if (type == PngFixture.PALETTE) {
      byte[] table = transparency(type, depth);
      int index = sample(x, y, depth);
      return index < table.length ? table[index] & 0xff : 255;
    }
    for (int c = 0; c < channels; c++) {
      if (sample(channels * x + c, y, depth) != sample(channels * 2 + c, 3, depth)) {
        return depth == 16 ? 0xffff : 255;
      }
    }
    return 0;
  }

  @ParameterizedTest(name = "type {0}, {1} bits, interlaced {2}")
  @MethodSource("forms")
  void alphaIsThatOfTheColor(int type, int depth, boolean interlaced) throws ImageFormatException {
    byte[] transparency = transparency(type, depth);
    Pixels pixels = ImageReader.decode(file(type, depth, interlaced, transparency));
    assertThat(pixels.hasAlpha()).isTrue();
    int transparent = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        assertThat(pixels.alpha(x, y)).as(x + "," + y).isEqualTo(alpha(type, depth, x, y));
        transparent += pixels.alpha(x, y) == 0 ? 1 : 0;
      }
    }
    assertThat(transparent).isBetween(1, WIDTH * HEIGHT - 1);
    assertThat(ImageReader.decode(pixels.toPng()).alpha(2, 3)).isEqualTo(pixels.alpha(2, 3));
  }

  @ParameterizedTest
  @CsvSource({"0, 8, 1", "0, 8, 3", "2, 8, 2", "2, 16, 7", "3, 8, 0", "6, 8, 6", "4, 8, 2"})
  void chunksOfWrongSizesAreIgnored(int type, int depth, int bytes) throws ImageFormatException {
    Pixels pixels = ImageReader.decode(file(type, depth, false, new byte[bytes]));
    assertThat(pixels.hasAlpha()).isEqualTo(type >= PngFixture.GRAY_ALPHA);
  }

  @Test
  void longTablesHaveTheColorsOfThePalette() throws ImageFormatException {
    byte[] table = new byte[1000];
    table[1] = 7;
    Pixels pixels = ImageReader.decode(file(PngFixture.PALETTE, 1, false, table));
    assertThat(pixels.alpha(0, 0)).isZero();
    assertThat(pixels.alpha(1, 0)).isEqualTo(7);
  }
}
