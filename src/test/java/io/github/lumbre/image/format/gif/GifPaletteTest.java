package io.github.lumbre.image.format.gif;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.animation.AnimationFixture;
import io.github.lumbre.image.animation.AnimationFrames;
import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Random;
import java.util.function.IntBinaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the choice of colors, and the dither. */
class GifPaletteTest {
  private static final int SIDE = 256;

  /** A sheet through the cube of colors: all different, with a slope in each channel. */
  private static final IntBinaryOperator SHEET = (x, y) -> x << 16 | y << 8 | (x + y) / 2;

  private static GifPalette palette(IntBinaryOperator argb) {
    ColorHistogram histogram = new ColorHistogram();
    histogram.add(
        IntStream.range(0, SIDE * SIDE)
            .map(i -> argb.applyAsInt(i % SIDE, i / SIDE) | 0xff << 24)
            .toArray());
    return GifPalette.of(histogram);
  }

  /** Returns the mean of a channel over the pattern, times 16. */
  private static int sum(GifPalette palette, int rgb, int channel) {
    byte[] bytes = palette.bytes();
    int sum = 0;
    for (int i = 0; i < 16; i++) {
      int index = palette.index(0xff << 24 | rgb, i % 4, i / 4);
      sum += bytes[3 * index + channel] & 0xff;
    }
    return sum;
  }

  /**
   * 256 colors divide the sheet into cells of about 16 x 16 values of red and green, so that the
   * nearest color is at most 11 away. The mean is off by at most a quarter of that (see the
   * damping), and by 1 for the rounding of cells and colors. At the edges of the sheet, the colors
   * that would make up for an error are missing.
   */
  @Test
  void gradientsHaveNoBands() {
    GifPalette palette = palette(SHEET);
    for (int x = 16; x < SIDE - 16; x += 3) {
      for (int y = 16; y < SIDE - 16; y += 3) {
        int rgb = SHEET.applyAsInt(x, y);
        for (int channel = 0; channel < 3; channel++) {
          int value = rgb >> 16 - 8 * channel & 0xff;
          assertThat(Math.abs(sum(palette, rgb, channel) - 16 * value))
              .as("channel %d of %06x", channel, rgb)
              .isLessThanOrEqualTo(16 * 4);
        }
      }
    }
  }

  /** The same color has the same index at the same place, whatever was asked for before. */
  @Test
  void thePatternIsFixedOnTheScreen() {
    GifPalette one = palette(SHEET);
    GifPalette other = palette(SHEET);
    Random random = new Random(1);
    for (int i = 0; i < 100_000; i++) {
      other.index(0xff << 24 | random.nextInt(1 << 24), random.nextInt(9), random.nextInt(9));
    }
    int mixed = 0;
    for (int i = 0; i < 20_000; i++) {
      int argb = 0xff << 24 | SHEET.applyAsInt(random.nextInt(SIDE), random.nextInt(SIDE));
      int index = one.index(argb, 3, 2);
      assertThat(other.index(argb, 7, 6)).isEqualTo(index);
      mixed += one.index(argb, 2, 2) == index ? 0 : 1;
    }
    assertThat(mixed).isPositive();
  }

  /** A red spot of 8 x 8 pixels among 65,536 gray and brown ones is not made gray. */
  @Test
  void smallObjectsKeepTheirColor() {
    GifPalette palette =
        palette((x, y) -> x < 8 && y < 8 ? 0xd01018 : y << 16 | (y + x / 8) / 2 << 8 | y / 2);
    assertThat(sum(palette, 0xd01018, 0)).isBetween(16 * 0xcc, 16 * 0xd4);
    assertThat(sum(palette, 0xd01018, 1)).isBetween(16 * 0x0c, 16 * 0x14);
    assertThat(sum(palette, 0xd01018, 2)).isBetween(16 * 0x14, 16 * 0x1c);
  }

  @Test
  void theNearestColorIsFoundAsByTryingAll() {
    Random random = new Random(2);
    for (int size : new int[] {1, 2, 7, 256}) {
      int[] colors = NearestColor.sorted(random.ints(size, 0, 1 << 24).toArray());
      NearestColor nearest = new NearestColor(colors);
      for (int i = 0; i < 5000; i++) {
        int rgb = random.nextInt(1 << 24);
        int found = nearest.index(rgb);
        int least = IntStream.of(colors).map(color -> distance(color, rgb)).min().orElseThrow();
        assertThat(distance(colors[found], rgb)).isEqualTo(least);
      }
    }
  }

  private static int distance(int a, int b) {
    int red = (a >> 16) - (b >> 16);
    int green = (a >> 8 & 0xff) - (b >> 8 & 0xff);
    int blue = (a & 0xff) - (b & 0xff);
    return 5 * red * red + 8 * green * green + 5 * blue * blue;
  }

  @Test
  void sizesArePowersOfTwo() {
    assertThat(palette((x, y) -> 0).bits()).isEqualTo(1);
    assertThat(palette((x, y) -> x % 3).bits()).isEqualTo(2);
    assertThat(palette((x, y) -> x % 129).bits()).isEqualTo(8);
    assertThat(palette(SHEET).bits()).isEqualTo(8);
    assertThat(palette(SHEET).bytes()).hasSize(3 * 256);
  }

  /** With one index for transparent pixels, 255 colors are left. */
  @Test
  void transparencyTakesOneIndex() {
    ColorHistogram histogram = new ColorHistogram();
    histogram.add(IntStream.range(0, 256).map(i -> 0x80 << 24 | i).toArray());
    assertThat(GifPalette.of(histogram).isTransparent()).isFalse();
    histogram.add(new int[] {0x7f << 24});
    GifPalette palette = GifPalette.of(histogram);
    assertThat(palette.isTransparent()).isTrue();
    assertThat(palette.transparent()).isLessThan(256);
    assertThat(palette.index(0x7fffffff, 0, 0)).isEqualTo(palette.transparent());
    assertThat(palette.bits()).isLessThanOrEqualTo(8);
  }

  /** The hash of a file that needs the whole way: many colors, dither, rectangles, full tables. */
  @Test
  void bytesAreTheSameOnEveryMachine(@TempDir Path folder) throws Exception {
    AnimationFrames frames =
        AnimationFixture.frames(
            folder,
            "30",
            AnimationFixture.pixels(SIDE, SIDE, false, SHEET),
            AnimationFixture.pixels(
                SIDE, SIDE, false, (x, y) -> SHEET.applyAsInt(x, x > y ? y : y * y & 0xff)));
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    GifWriter.write(frames, out);
    byte[] hash = MessageDigest.getInstance("SHA-256").digest(out.toByteArray());
    assertThat(HexFormat.of().formatHex(hash, 0, 8)).isEqualTo("13e6ddb94050f0c7");
  }
}
