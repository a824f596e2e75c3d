package io.github.lumbre.image.compare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.internal.ErrorMap;
import org.junit.jupiter.api.Test;

/** Tests the error metrics of pictures. */
class PictureErrorTest {
  @Test
  void samePicturesHaveNoError() {
    Image picture = TestPictures.noisy(40, 30, .5);
    assertThat(PictureError.of(picture, picture)).isEqualTo(new PictureError(0, 0, 0, 0, 0, 1, 0));
  }

  @Test
  void anEvenOffsetIsAllBias() {
    Image reference = TestPictures.of(20, 10, (x, y, c) -> .5);
    Image brighter = TestPictures.of(20, 10, (x, y, c) -> .75);
    PictureError error = PictureError.of(brighter, reference);
    assertThat(error.rmse()).isEqualTo(.25);
    assertThat(error.bias()).isEqualTo(.25);
    assertThat(error.relativeMse()).isCloseTo(.0625 / .26, within(1e-12));
    assertThat(error.percentile999()).isEqualTo(.25);
    assertThat(PictureError.of(reference, brighter).bias()).isEqualTo(-.25);
  }

  @Test
  void theReferenceIsWhatErrorsAreRelativeTo() {
    Image dark = TestPictures.of(4, 4, (x, y, c) -> 0);
    Image light = TestPictures.of(4, 4, (x, y, c) -> 1);
    assertThat(PictureError.of(light, dark).relativeMse()).isCloseTo(100, within(1e-9));
    assertThat(PictureError.of(dark, light).relativeMse()).isCloseTo(1 / 1.01, within(1e-12));
  }

  @Test
  void opposedErrorsCancelInTheBiasAlone() {
    Image reference = TestPictures.of(20, 10, (x, y, c) -> 1);
    Image chequered = TestPictures.of(20, 10, (x, y, c) -> (x + y) % 2 == 0 ? .5 : 1.5);
    PictureError error = PictureError.of(chequered, reference);
    assertThat(error.bias()).isZero();
    assertThat(error.rmse()).isEqualTo(.5);
  }

  @Test
  void theThousandthLargestErrorIsThePercentile() {
    Image reference = TestPictures.of(100, 10, (x, y, c) -> 0);
    Image spiky = TestPictures.of(100, 10, (x, y, c) -> c == 0 && y == 0 && x < 4 ? x + 1 : 0);
    PictureError error = PictureError.of(spiky, reference);
    assertThat(error.largest()).isEqualTo(4);
    // Of 3000 values three may be above.
    assertThat(error.percentile999()).isEqualTo(1);
  }

  @Test
  void similarityOfEvenPicturesIsThatOfTheirMeans() {
    Image a = TestPictures.of(20, 20, (x, y, c) -> .2140411);
    Image b = TestPictures.of(20, 20, (x, y, c) -> 1);
    // Encoded .5 and 1: (2ab + c1) / (a² + b² + c1), Wang et al. 2004, eq. 6.
    double expected = (2 * .5 + 1e-4) / (.25 + 1 + 1e-4);
    assertThat(PictureError.of(a, b).ssim()).isCloseTo(expected, within(1e-6));
  }

  @Test
  void similarityFallsWithNoise() {
    Image reference = TestPictures.pattern(40, 30);
    double little = PictureError.of(TestPictures.noisy(40, 30, .1), reference).ssim();
    double much = PictureError.of(TestPictures.noisy(40, 30, .6), reference).ssim();
    assertThat(little).isLessThan(1).isGreaterThan(much);
  }

  @Test
  void transparentPixelsLookBlack() {
    Image black = TestPictures.of(3, 1, (x, y, c) -> 0);
    Image unseen = new Image(3, 1, new float[] {9, 9, 9, 9, 9, 9, 9, 9, 9}, new float[3]);
    assertThat(PictureError.of(unseen, black).rmse()).isZero();
  }

  @Test
  void differentSizesAreRefused() {
    assertThatThrownBy(() -> PictureError.of(Image.black(2, 3), Image.black(3, 2)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("reference: expected 2x3 pixels, found 3x2");
  }

  @Test
  void theMapIsBlackWithoutErrorAndBrightensWithIt() {
    Image reference = TestPictures.of(4, 1, (x, y, c) -> 1);
    Image wrong = TestPictures.of(4, 1, (x, y, c) -> 1 + x * x * x * .02);
    Image map = ErrorMap.of(wrong, reference);
    assertThat(map.pixel(0, 0).luminance()).isLessThan(1e-3);
    for (int x = 1; x < 4; x++) {
      assertThat(map.pixel(x, 0).luminance()).isGreaterThan(map.pixel(x - 1, 0).luminance());
    }
  }
}
