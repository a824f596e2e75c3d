package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests the loops of the network. */
class LoopsTest {
  private static final int COUNT = 1000;

  /** Weights that are finite halves: many, and those at the ends of their range. */
  private static float weight(Random random, int kind) {
    short bits = (short) random.nextInt(1 << 16);
    float weight =
        switch (kind) {
          case 0 -> Network.half((short) (bits & 0x83ff));
          case 1 -> Network.half((short) (bits | 0x03ff));
          default -> Network.half(bits);
        };
    return Float.isFinite(weight) && Math.abs(weight) <= 65504 ? weight : 1;
  }

  /** Values of all magnitudes that rounding leaves finite, many of them near a power of two. */
  private static float value(Random random, int kind) {
    float fraction =
        switch (kind) {
          case 0 -> random.nextFloat();
          case 1 -> 1 + (random.nextInt(9) - 4) * 0x1p-12f;
          default -> (8191 - random.nextInt(3)) * 0x1p-13f;
        };
    return Loops.rounded(
        (random.nextBoolean() ? 1 : -1) * Math.scalb(fraction, random.nextInt(240) - 149));
  }

  /** Sums that cancel a product, or nearly, or end between two floats beside it. */
  private static float sum(Random random, int kind, float product) {
    return switch (kind) {
      case 0 -> -product;
      case 1 -> -product * (1 + (random.nextInt(5) - 2) * 0x1p-23f);
      case 2 -> product * Math.scalb(1f, random.nextInt(60) - 30);
      case 3 -> Math.scalb(random.nextFloat(), random.nextInt(200) - 149);
      default -> 0;
    };
  }

  /** Machines without fused operations get the same pictures. */
  @Test
  void sumsHaveTheSameBitsFusedOrNot() {
    Random random = new Random(1);
    for (int trial = 0; trial < 2000; trial++) {
      float[] weights = new float[6];
      for (int i = 0; i < weights.length; i++) {
        weights[i] = weight(random, random.nextInt(4));
      }
      float[][] rows = new float[3][COUNT];
      float[][] sums = new float[4][COUNT];
      for (int i = 0; i < COUNT; i++) {
        for (float[] row : rows) {
          row[i] = value(random, random.nextInt(3));
        }
        sums[0][i] = sum(random, random.nextInt(5), weights[0] * rows[0][i]);
        sums[1][i] = sum(random, random.nextInt(5), weights[3] * rows[0][i]);
      }
      sums[2] = sums[0].clone();
      sums[3] = sums[1].clone();
      Loops.addThree(rows, 0, sums[0], sums[1], COUNT, weights, 0, 3, true);
      Loops.addThree(rows, 0, sums[2], sums[3], COUNT, weights, 0, 3, false);
      assertThat(sums[2]).isEqualTo(sums[0]);
      assertThat(sums[3]).isEqualTo(sums[1]);
    }
  }

  @Test
  void sumsAreThoseOfSixProducts() {
    float[][] rows = {{9}, {1}, {2}, {.5f}};
    float[] sum = {100};
    float[] other = {-1};
    Loops.addThree(rows, 1, sum, other, 1, new float[] {7, 3, 5, 8, 2, 4, 16}, 1, 4, true);
    assertThat(sum[0]).isEqualTo(100 + 3 + 5 * 2 + 8 * .5f);
    assertThat(other[0]).isEqualTo(-1 + 2 + 4 * 2 + 16 * .5f);
  }

  @Test
  void roundedValuesHaveThirteenBits() {
    assertThat(Loops.rounded(0)).isZero();
    assertThat(Loops.rounded(1)).isEqualTo(1);
    assertThat(Loops.rounded(8191)).isEqualTo(8191);
    assertThat(Loops.rounded(8193)).isIn(8192f, 8194f);
    assertThat(Loops.rounded(-8194.9f)).isEqualTo(-8194);
    assertThat(Loops.rounded(1e-30f)).isZero();
    Random random = new Random(2);
    for (int i = 0; i < 100_000; i++) {
      float value = Math.scalb(1 + random.nextFloat(), random.nextInt(90) - 30);
      float rounded = Loops.rounded(value);
      assertThat(Float.floatToRawIntBits(rounded) & 0x7ff).isZero();
      assertThat(Math.abs(rounded - value)).isLessThanOrEqualTo(value * 0x1p-13f);
    }
  }

  @Test
  void negativeValuesAreReplacedAndOthersRounded() {
    float[] values = {5.00001f, -3, 2.00001f, .25f, -0f, -1};
    Loops.rectify(values, 1, 5);
    assertThat(values).containsExactly(5.00001f, 0, 2, .25f, 0f, -1);
  }
}
