package io.github.lumbre.camera.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.testing.ChiSquare;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.ScriptedSampler;
import org.junit.jupiter.api.Test;

/** Tests the sampling of lens points from a mask. */
class BokehCacheTest {
  private static final double LAST = 1 - 0x1p-53;
  private static final int SAMPLES = Effort.count(300_000, 3_000_000);

  /** Returns an asymmetric mask: a heart with one higher lobe; row 0 is the bottom. */
  private static boolean[][] heart(int size) {
    boolean[][] white = new boolean[size][size];
    for (int row = 0; row < size; row++) {
      for (int column = 0; column < size; column++) {
        double x = (column + .5) / size * 2.6 - 1.3;
        double y = (row + .5) / size * 2.6 - 1.3;
        double d = x * x + y * y - 1;
        white[row][column] = d * d * d - x * x * y * y * y < 0 && !(x < -.3 && y > .5);
      }
    }
    return white;
  }

  private static ScriptedSampler falling(double u, double v) {
    return new ScriptedSampler().with(Sampler.LENS, u, v).with(Sampler.MASK, .5, .5, .5);
  }

  /** Returns sample counts per mask texel, over many pixels and over the samples of one pixel. */
  private static long[] histogram(BokehCache cache, int size, int n) {
    long[] counts = new long[size * size];
    SobolSampler sampler = new SobolSampler(Effort.seed(4));
    for (int i = 0; i < n; i++) {
      sampler.startSample(i % 1000, i / 1000, i % 7);
      Point2 p = cache.sample(sampler);
      int column = (int) ((p.x() + .5) * size);
      int row = (int) ((p.y() + .5) * size);
      counts[row * size + column]++;
    }
    return counts;
  }

  @Test
  void whiteAreaIsCoveredEvenlyAndBlackNever() {
    int size = 64;
    boolean[][] white = heart(size);
    int n = SAMPLES;
    long[] counts = histogram(new BokehCache(white), size, n);
    double[] expected = new double[counts.length];
    int texels = 0;
    for (int i = 0; i < counts.length; i++) {
      texels += white[i / size][i % size] ? 1 : 0;
    }
    assertThat(texels).isBetween(size * size / 5, size * size / 2);
    for (int i = 0; i < counts.length; i++) {
      expected[i] = white[i / size][i % size] ? (double) n / texels : 0;
    }
    ChiSquare test = ChiSquare.of(counts, expected);
    assertThat(test.impossible()).isZero();
    assertThat(test.passes()).isTrue();
  }

  @Test
  void insideOfATexelIsCoveredEvenly() {
    boolean[][] white = new boolean[4][4];
    white[1][2] = true;
    long[] counts = histogram(new BokehCache(white), 64, SAMPLES);
    long[] inside = new long[256];
    long total = 0;
    for (int i = 0; i < 256; i++) {
      inside[i] = counts[(16 + i / 16) * 64 + 32 + i % 16];
      total += inside[i];
    }
    assertThat(total).isEqualTo(SAMPLES);
    assertThat(ChiSquare.uniform(inside).passes()).isTrue();
  }

  @Test
  void rightIsRightAndTheLastRowIsUp() {
    boolean[][] white = new boolean[3][5];
    white[2][4] = true;
    for (double u : new double[] {0, .5, LAST}) {
      Point2 p = new BokehCache(white).sample(falling(u, u));
      assertThat(p.x()).isBetween(.3, .5);
      assertThat(p.y()).isBetween(1 / 6.0, .5);
    }
  }

  @Test
  void pointsThatFallOnWhiteAreUsedAsTheyAre() {
    boolean[][] white = new boolean[2][2];
    white[0][1] = true;
    white[1][1] = true;
    BokehCache cache = new BokehCache(white);
    ScriptedSampler onWhite = falling(.7, .2);
    assertThat(cache.sample(onWhite).x()).isCloseTo(.2, within(1e-16));
    assertThat(cache.sample(onWhite).y()).isCloseTo(-.3, within(1e-16));
    assertThat(onWhite.asked()).containsExactlyInAnyOrder(Sampler.LENS, Sampler.LENS + 1);
    ScriptedSampler onBlack =
        new ScriptedSampler().with(Sampler.LENS, .2, .2).with(Sampler.MASK, .5, .5, .25);
    assertThat(cache.sample(onBlack)).isEqualTo(new Point2(.25, .125));
    assertThat(onBlack.asked()).contains(Sampler.MASK, Sampler.MASK + 1, Sampler.MASK + 2);
  }

  @Test
  void extremeNumbersStayOnTheLens() {
    for (int size : new int[] {1, 2, 3, 49, 1000}) {
      boolean[][] white = new boolean[size][size];
      white[size - 1][0] = true;
      BokehCache cache = new BokehCache(white);
      for (double u : new double[] {0, .5, LAST}) {
        ScriptedSampler sampler =
            new ScriptedSampler().with(Sampler.LENS, u, u).with(Sampler.MASK, u, u, u);
        Point2 p = cache.sample(sampler);
        assertThat(p.x()).isBetween(-.5, -.5 + 1.0 / size);
        assertThat(p.y()).isBetween(.5 - 1.0 / size - 1e-15, .5);
      }
    }
  }

  @Test
  void whiteMaskIsTheWholeSquare() {
    BokehCache cache = new BokehCache(new boolean[][] {{true}});
    assertThat(cache.sample(falling(0, 0))).isEqualTo(new Point2(-.5, -.5));
    assertThat(cache.sample(falling(.75, .25))).isEqualTo(new Point2(.25, -.25));
  }

  @Test
  void maskWithoutWhiteIsRefused() {
    assertThatThrownBy(() -> new BokehCache(new boolean[3][3]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("at least one white texel");
    assertThatThrownBy(() -> new BokehCache(new boolean[0][0]))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
