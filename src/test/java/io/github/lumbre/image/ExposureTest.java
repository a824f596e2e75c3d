package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.internal.ImageFixture;
import org.junit.jupiter.api.Test;

/** Tests manual and automatic exposure. */
class ExposureTest {
  private static double automatic(double... grays) {
    return Exposure.AUTO.factor(ImageFixture.grays(grays));
  }

  @Test
  void aStopDoublesTheBrightness() {
    Image image = Image.black(1, 1);
    assertThat(Exposure.NONE.factor(image)).isEqualTo(1);
    assertThat(Exposure.of(3).factor(image)).isEqualTo(8);
    assertThat(Exposure.of(-1).factor(image)).isEqualTo(.5);
  }

  @Test
  void automaticBringsTheGeometricMeanToMiddleGray() {
    assertThat(automatic(.5)).isCloseTo(.36, within(1e-12));
    assertThat(automatic(.25, 4)).isCloseTo(.18, within(1e-12));
  }

  @Test
  void blackPixelsDoNotCountAndVeryDarkOnesOnlySoMuch() {
    assertThat(automatic(.5, 0, 0, -1, Double.NaN)).isCloseTo(.36, within(1e-12));
    assertThat(automatic(1e-30)).isCloseTo(.18e6, within(1e-3));
  }

  @Test
  void aBlackPictureStaysAsItIs() {
    assertThat(automatic(0, 0)).isEqualTo(1);
  }

  @Test
  void aPixelBeyondTheRangeDoesNotBlackenTheOthers() {
    assertThat(automatic(1, 1, 1, Double.POSITIVE_INFINITY)).isBetween(1e-12, .18);
  }

  @Test
  void stopsMustBeFinite() {
    assertThatThrownBy(() -> Exposure.of(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("stops: expected a finite number, found NaN");
  }
}
