package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Tests the arithmetic of colors. */
class RgbTest {
  private static final double[] NOT_FINITE = {
    Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY
  };

  /** Returns black except for one channel. */
  private static Rgb only(int channel, double value) {
    return new Rgb(channel == 0 ? value : 0, channel == 1 ? value : 0, channel == 2 ? value : 0);
  }

  @Test
  void arithmeticIsByChannel() {
    Rgb color = new Rgb(1, 2, 3);
    assertThat(color.plus(new Rgb(10, 20, 30))).isEqualTo(new Rgb(11, 22, 33));
    assertThat(color.times(new Rgb(10, 20, 30))).isEqualTo(new Rgb(10, 40, 90));
    assertThat(color.times(4)).isEqualTo(new Rgb(4, 8, 12));
    assertThat(Rgb.gray(2)).isEqualTo(new Rgb(2, 2, 2));
  }

  @Test
  void eachChannelCountsForItself() {
    for (int channel = 0; channel < 3; channel++) {
      assertThat(only(channel, 5).max()).isEqualTo(5);
      assertThat(only(channel, 1e-300).isBlack()).isFalse();
      assertThat(only(channel, -1).isBlack()).isFalse();
      assertThat(only(channel, 3).clampedToOne()).isEqualTo(only(channel, 1));
      for (double value : NOT_FINITE) {
        assertThat(only(channel, value).isFinite()).isFalse();
      }
    }
    assertThat(Rgb.BLACK.isBlack()).isTrue();
    assertThat(new Rgb(1, -2, 1e308).isFinite()).isTrue();
  }

  @Test
  void clampingKeepsWhatIsNotAboveOne() {
    for (Rgb kept : new Rgb[] {Rgb.BLACK, Rgb.WHITE, new Rgb(-1, .5, 1)}) {
      assertThat(kept.clampedToOne()).isSameAs(kept);
    }
    assertThat(new Rgb(2, .5, -1).clampedToOne()).isEqualTo(new Rgb(1, .5, -1));
  }

  @Test
  void luminanceOfGrayIsItself() {
    assertThat(Rgb.gray(7).luminance()).isCloseTo(7, within(1e-12));
    assertThat(only(1, 1).luminance()).isGreaterThan(only(0, 1).luminance());
    assertThat(only(0, 1).luminance()).isGreaterThan(only(2, 1).luminance());
  }
}
