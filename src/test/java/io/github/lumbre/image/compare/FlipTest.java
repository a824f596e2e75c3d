package io.github.lumbre.image.compare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/**
 * Compares with the results of the authors' evaluator, flip_evaluator 1.7 (PyPI), for the same
 * pictures encoded to sRGB: {@code evaluate(reference, test, "LDR", applyMagma=False)}. That
 * evaluator computes in floats.
 */
class FlipTest {
  private static final double FLOATS = 5e-5;

  @Test
  void noiseDiffersAsTheAuthorsSay() {
    Plane map = Flip.map(TestPictures.noisy(64, 48, .2), TestPictures.pattern(64, 48));
    assertThat(map.mean()).isCloseTo(.1134511, within(FLOATS));
    assertThat(map.values()[0]).isCloseTo(.210723, within(1e-4));
    assertThat(map.values()[5 * 64 + 7]).isCloseTo(.158249, within(1e-4));
  }

  @Test
  void picturesSmallerThanTheFiltersDifferAsTheAuthorsSay() {
    Plane map = Flip.map(TestPictures.noisy(16, 12, .5), TestPictures.pattern(16, 12));
    assertThat(map.mean()).isCloseTo(.2135724, within(FLOATS));
  }

  @Test
  void movedEdgesDifferAsTheAuthorsSay() {
    Image moved =
        TestPictures.of(64, 48, (x, y, c) -> TestPictures.patternAt((x + 61) % 64, y, c, 64, 48));
    assertThat(Flip.map(moved, TestPictures.pattern(64, 48)).mean())
        .isCloseTo(.2938412, within(FLOATS));
  }

  @Test
  void evenGraysDifferAsTheAuthorsSay() {
    Image dark = TestPictures.of(20, 20, (x, y, c) -> .3);
    Image light = TestPictures.of(20, 20, (x, y, c) -> .5);
    assertThat(Flip.map(light, dark).mean()).isCloseTo(.3725436, within(FLOATS));
  }

  @Test
  void greenAndBlueDifferMost() {
    Image green = TestPictures.of(20, 20, (x, y, c) -> c == 1 ? 1 : 0);
    Image blue = TestPictures.of(20, 20, (x, y, c) -> c == 2 ? 1 : 0);
    assertThat(Flip.map(green, blue).mean()).isCloseTo(1, within(1e-9));
  }

  @Test
  void tilesHaveTheirMeans() {
    Image picture = TestPictures.pattern(20, 12);
    float[] changed = picture.rgb().clone();
    Arrays.fill(changed, 3 * (10 * 20 + 18), 3 * (10 * 20 + 20), 1 - changed[3 * (10 * 20 + 18)]);
    Image other = new Image(20, 12, changed, new float[0]);
    Plane map = Flip.map(other, picture);
    double[] tiles = Flip.tiles(other, picture, 8);
    assertThat(tiles).hasSize(6);
    int[] pixels = {64, 64, 32, 32, 32, 16};
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      sum += tiles[i] * pixels[i];
      assertThat(tiles[i]).isLessThanOrEqualTo(tiles[5]);
    }
    assertThat(tiles[5]).isGreaterThan(2 * tiles[1]);
    assertThat(sum / (20 * 12)).isCloseTo(map.mean(), within(1e-12));
  }

  @Test
  void samePicturesDoNotDiffer() {
    Image picture = TestPictures.noisy(16, 12, .5);
    assertThat(Flip.map(picture, picture).values()).containsOnly(0);
  }
}
