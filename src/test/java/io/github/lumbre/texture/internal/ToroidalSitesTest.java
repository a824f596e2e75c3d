package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares nearest sites with a brute-force search. */
class ToroidalSitesTest {
  private static double around(double a, double b, double size) {
    double d = Math.abs(a - b);
    return Math.min(d, size - d);
  }

  private static int nearest(double[] xs, double[] ys, double w, double h, double x, double y) {
    int best = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < xs.length; i++) {
      double dx = around(xs[i], x, w);
      double dy = around(ys[i], y, h);
      if (dx * dx + dy * dy < least) {
        least = dx * dx + dy * dy;
        best = i;
      }
    }
    return best;
  }

  private static void assertLikeBruteForce(
      double[] xs, double[] ys, int width, int height, int queries) {
    ToroidalSites sites = new ToroidalSites(xs, ys, width, height);
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < queries; i++) {
      double x = random.nextInt(width) + .5;
      double y = random.nextInt(height) + .5;
      assertThat(sites.nearest(x, y)).isEqualTo(nearest(xs, ys, width, height, x, y));
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, 1, 1",
    "1, 64, 64, 100",
    "2, 64, 64, 1000",
    "3, 100, 1, 1000",
    "5, 1, 100, 1000",
    "7, 500, 300, 2000",
    "10, 16384, 2, 2000",
    "12, 3, 16384, 2000",
    "30, 500, 500, 5000",
    "1000, 1000, 999, 3000",
    "1000, 1, 1, 1",
    "4321, 16384, 1, 2000",
    "100000, 300, 700, 100",
    "1000000, 16384, 16384, 10",
    "1000000, 1, 16384, 10"
  })
  void randomSitesAreFoundAsByBruteForce(int count, int width, int height, int queries) {
    SplittableRandom random = new SplittableRandom(count);
    double[] xs = random.doubles(count, 0, width).toArray();
    double[] ys = random.doubles(count, 0, height).toArray();
    assertLikeBruteForce(xs, ys, width, height, queries);
  }

  @ParameterizedTest
  @CsvSource({
    "20, 40, 30",
    "400, 64, 64",
    "400, 1, 500",
    "3000, 90, 50",
    "36, 100, 400",
    "36, 400, 100"
  })
  void crowdedSitesAreFoundFromAfar(int count, int width, int height) {
    SplittableRandom random = new SplittableRandom(count);
    double[] xs = random.doubles(count, 0, .1 * width).toArray();
    double[] ys = random.doubles(count, .9 * height, height).toArray();
    assertLikeBruteForce(xs, ys, width, height, 2000);
  }

  @ParameterizedTest
  @CsvSource({"10, 8, 8", "100, 8, 8", "500, 20, 7", "64, 1, 1"})
  void tiesGoToTheLowestIndex(int count, int width, int height) {
    SplittableRandom random = new SplittableRandom(count);
    // With integer coordinates, nearly every distance occurs more than once, and many sites
    // coincide.
    double[] xs = random.ints(count, 0, width + 1).asDoubleStream().toArray();
    double[] ys = random.ints(count, 0, height + 1).asDoubleStream().toArray();
    assertLikeBruteForce(xs, ys, width, height, 1000);
  }

  @ParameterizedTest
  @CsvSource({"20000, 40, 30", "9000, 1, 500"})
  void sitesDenserThanTexelsAreFoundAsByBruteForce(int count, int width, int height) {
    SplittableRandom random = new SplittableRandom(count);
    double[] xs = random.doubles(count, 0, width).toArray();
    double[] ys = random.doubles(count, 0, height).toArray();
    assertLikeBruteForce(xs, ys, width, height, 1000);
  }

  /** Both sites are 0.5 units from the point; one of them is just outside the point's cell. */
  @Test
  void tiesAcrossTheSideOfACellGoToTheLowestIndex() {
    ToroidalSites sites = new ToroidalSites(new double[] {2, 1}, new double[] {.5, .5}, 4, 1);
    assertThat(sites.nearest(1.5, .5)).isZero();
  }

  @Test
  void theOppositeSideIsNear() {
    ToroidalSites sites =
        new ToroidalSites(new double[] {50, 99, 20}, new double[] {50, 99, 20}, 100, 100);
    assertThat(sites.nearest(.5, .5)).isEqualTo(1);
    assertThat(sites.nearest(.5, 99.5)).isEqualTo(1);
    assertThat(sites.nearest(52, 48)).isEqualTo(0);
  }
}
