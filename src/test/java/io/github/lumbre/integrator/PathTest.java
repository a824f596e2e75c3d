package io.github.lumbre.integrator;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import org.junit.jupiter.api.Test;

/** Tests the sums of one path. */
class PathTest {
  private final Path path = new Path();

  @Test
  void newPathsHaveNoLightAndAreWhite() {
    path.begin();
    path.add(1, 2, 3);
    path.scale(.5, .25, .125);
    path.leave(7);
    path.split(3, 2);
    path.begin();
    assertThat(path.radiance()).isEqualTo(Rgb.BLACK);
    assertThat(path.throughput()).isEqualTo(1);
    assertThat(path.pdf()).isInfinite();
    assertThat(path.isSplit()).isFalse();
  }

  @Test
  void lightIsMultipliedByTheProductOfAllWeights() {
    path.begin();
    path.add(1, 2, 4);
    path.scale(.5, .25, .125);
    path.add(8, 8, 8);
    path.scale(.5, 4, 2);
    path.add(1, 1, 1);
    assertThat(path.radiance()).isEqualTo(new Rgb(1 + 4 + .25, 2 + 2 + 1, 4 + 1 + .25));
    assertThat(path.throughput()).isEqualTo(1);
    path.scale(.5, .125, .25);
    assertThat(path.throughput()).isEqualTo(.125);
    path.scale(1, 1, 64);
    assertThat(path.throughput()).isEqualTo(4);
    path.leave(7);
    assertThat(path.pdf()).isEqualTo(7);
  }

  /** All branches together find what one path finds. */
  @Test
  void branchesShareTheThroughput() {
    for (int branches = 1; branches <= 8; branches *= 2) {
      path.begin();
      path.scale(.5, 2, .125);
      path.add(1, 1, 1);
      path.split(5, branches);
      assertThat(path.isSplit()).isEqualTo(branches > 1);
      for (int branch = 0; branch < branches; branch++) {
        assertThat(path.returnToSplit()).isEqualTo(5);
        // Branches end by roulette as often as paths that are not split.
        assertThat(path.throughput()).isEqualTo(2);
        path.add(1, 1, 1);
        path.scale(.5, .5, .5);
        path.add(2, 4, 6);
      }
      assertThat(path.radiance()).isEqualTo(new Rgb(.5 * 3, 2 * 4, .125 * 5));
    }
  }

  /** Specular surfaces do not count as the first one, and leave it to be found. */
  @Test
  void survivalIsTheThroughputComparedWithTheFirstSurface() {
    path.begin();
    // Nothing but mirrors and glass: not before the fourth vertex.
    path.scale(.125, .25, .125);
    path.leave(Double.POSITIVE_INFINITY);
    assertThat(path.survival(2)).isEqualTo(1);
    assertThat(path.survival(3)).isEqualTo(.25);
    path.scale(.5, .25, .125);
    path.leave(7);
    assertThat(path.survival(1)).isEqualTo(1);
    path.scale(.5, .5, .5);
    path.leave(7);
    assertThat(path.survival(1)).isEqualTo(1);
    path.scale(.25, .25, .25);
    path.leave(Double.POSITIVE_INFINITY);
    assertThat(path.survival(1)).isEqualTo(.25);
    path.scale(0, 0, 0);
    path.leave(7);
    assertThat(path.survival(1)).isZero();
  }

  /** A first surface that scatters nothing ends the path. */
  @Test
  void blackPathsDoNotSurvive() {
    path.begin();
    path.scale(0, 0, 0);
    path.leave(7);
    assertThat(path.survival(1)).isZero();
  }

  /** Each branch has its own weight behind the surface where the path was split. */
  @Test
  void survivalOfABranchDoesNotDependOnOthers() {
    path.begin();
    path.split(0, 4);
    for (double weight : new double[] {1, .125, .5}) {
      path.returnToSplit();
      path.scale(weight, weight, weight);
      path.leave(7);
      assertThat(path.survival(1)).isEqualTo(1);
      path.scale(.25, .25, .25);
      assertThat(path.survival(1)).isEqualTo(.5);
    }
  }
}
