package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.internal.Srgb;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** 8-bit pictures have no bands, and keep what lies on a step. */
class DitherTest {
  private static ImageWriter.Options options(ToneCurve curve, int bits) {
    return new ImageWriter.Options(Exposure.NONE, curve, bits, Map.of());
  }

  private static Pixels png(Image image, ImageWriter.Options options) throws Exception {
    return ImageReader.decode(image.toPng(options));
  }

  /** Returns a gray picture of encoded values. */
  private static Image encoded(int width, int height, IntToDoubleFunction at) {
    float[] rgb = new float[3 * width * height];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) Srgb.decode(at.applyAsDouble(i / 3 % width) / 255);
    }
    return new Image(width, height, rgb, new float[0]);
  }

  /** 64 steps over 4,096 pixels: a step is 64 pixels wide, eight blocks. */
  @ParameterizedTest
  @EnumSource(names = {"SRGB", "GAMMA22"})
  void meansOfBlocksFollowAGradient(ToneCurve curve) throws Exception {
    for (int start : new int[] {0, 20, 90, 191}) {
      Image gradient = encoded(4096, 8, x -> start + (x / 8 * 8 + 3.5) / 64);
      double[] wanted = new double[512];
      for (int block = 0; block < 512; block++) {
        double linear = gradient.pixel(8 * block, 0).r();
        wanted[block] = 255 * curve.apply(Rgb.gray(linear)).r();
      }
      Pixels written = png(gradient, options(curve, 8));
      for (int block = 0; block < 512; block++) {
        double sum = 0;
        for (int i = 0; i < 64; i++) {
          sum += written.raw(8 * block + i % 8, i / 8, 0);
        }
        assertThat(sum / 64).isCloseTo(wanted[block], within(.02));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"SRGB", "GAMMA22"})
  void valuesOnAStepStay(ToneCurve curve) throws Exception {
    for (int step = 0; step <= 255; step++) {
      double value = step / 255.0;
      double linear = curve == ToneCurve.SRGB ? Srgb.decode(value) : StrictMath.pow(value, 2.2);
      float[] rgb = new float[3 * 64];
      Arrays.fill(rgb, (float) linear);
      Pixels written = png(new Image(8, 8, rgb, new float[0]), options(curve, 8));
      for (int i = 0; i < 64; i++) {
        assertThat(written.raw(i % 8, i / 8, 1)).isEqualTo(step);
      }
    }
  }

  /** Each value becomes one of the two steps around it. */
  @Test
  void noValueMovesByAStep() throws Exception {
    Random random = new Random(5);
    float[] rgb = new float[3 * 64 * 64];
    IntStream.range(0, rgb.length).forEach(i -> rgb[i] = random.nextFloat() * 1.1f - .05f);
    rgb[0] = Float.NaN;
    rgb[1] = Float.POSITIVE_INFINITY;
    rgb[2] = Float.MIN_VALUE;
    Image image = new Image(64, 64, rgb, new float[0]);
    Pixels written = png(image, ImageWriter.Options.DEFAULT);
    for (int i = 3; i < rgb.length; i++) {
      double value = 255 * Srgb.encode(rgb[i]);
      int raw = written.raw(i / 3 % 64, i / 3 / 64, i % 3);
      assertThat((double) raw).isBetween(Math.floor(value - 1e-5), Math.ceil(value + 1e-5));
    }
    assertThat(written.raw(0, 0, 0)).isZero();
    assertThat(written.raw(0, 0, 1)).isEqualTo(255);
    assertThat(written.raw(0, 0, 2)).isZero();
  }

  /** A part of a picture has the pixels of the whole, wherever it begins. */
  @Test
  void partsAgreeWithTheWhole() throws Exception {
    Image whole = encoded(40, 30, x -> 100 + .37 * x);
    Pixels all = png(whole, ImageWriter.Options.DEFAULT);
    Image part = encoded(11, 9, x -> 100 + .37 * (x + 13));
    ImageWriter.Options placed =
        ImageWriter.Options.DEFAULT.withDither(Optional.of(new Dither(13, 6)));
    Pixels written = png(part, placed);
    for (int i = 0; i < 99; i++) {
      int x = i % 11;
      int y = i / 11;
      assertThat(written.raw(x, y, 0)).isEqualTo(all.raw(x + 13, y + 6, 0));
    }
  }

  @Test
  void alphaAnd16BitsAndRoundedPicturesAreNotDithered() throws Exception {
    float[] rgb = new float[3 * 64];
    float[] alpha = new float[64];
    Arrays.fill(rgb, (float) Srgb.decode(100.4 / 255));
    Arrays.fill(alpha, 100.4f / 255);
    Image image = new Image(8, 8, rgb, alpha);
    Pixels dithered = png(image, ImageWriter.Options.DEFAULT);
    Pixels rounded = png(image, ImageWriter.Options.ROUNDED);
    Pixels wide = png(image, options(ToneCurve.SRGB, 16));
    int[] steps = new int[2];
    for (int i = 0; i < 64; i++) {
      assertThat(dithered.alpha(i % 8, i / 8)).isEqualTo(100);
      assertThat(rounded.raw(i % 8, i / 8, 0)).isEqualTo(100);
      assertThat(wide.raw(i % 8, i / 8, 0)).isEqualTo((int) Math.round(100.4 * 257));
      steps[dithered.raw(i % 8, i / 8, 0) - 100]++;
    }
    assertThat(steps[1]).isBetween(25, 26);
  }

  /** The thresholds of 8x8 pixels are all different, and neighbors are far apart. */
  @Test
  void thresholdsAreEveryPartOfAStep() {
    Dither dither = Dither.FULL_FRAME;
    assertThat(IntStream.range(0, 64).mapToDouble(i -> dither.threshold(i % 8, i / 8)).sorted())
        .containsExactly(
            IntStream.range(0, 64).mapToObj(k -> (2 * k + 1) / 128.0).toArray(Double[]::new));
    for (int i = 0; i < 64; i++) {
      double here = dither.threshold(i % 8, i / 8);
      assertThat(Math.abs(here - dither.threshold(i % 8 + 1, i / 8))).isGreaterThanOrEqualTo(.25);
    }
    assertThat(new Dither(3, 5).threshold(2, 1)).isEqualTo(dither.threshold(5, 6));
  }
}
