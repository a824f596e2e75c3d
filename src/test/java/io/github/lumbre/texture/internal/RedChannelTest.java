package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import org.junit.jupiter.api.Test;

/** Tests the scalar texture of a red channel. */
class RedChannelTest {
  private static double value(double red, double factor, double min, double max) {
    return new RedChannel(Texture.constant(new Rgb(red, 7, 7)), factor, min, max)
        .at(new TexturePoint(0, 0));
  }

  @Test
  void redIsMultipliedByTheFactor() {
    assertThat(value(.5, .5, 0, 1)).isEqualTo(.25);
  }

  @Test
  void theProductIsLimitedToTheRange() {
    assertThat(value(.5, 4, 0, 1)).isEqualTo(1);
    assertThat(value(.25, 2, 1, Double.POSITIVE_INFINITY)).isEqualTo(1);
    assertThat(value(.5, 400, 0, Double.POSITIVE_INFINITY)).isEqualTo(200);
  }

  @Test
  void aRangeOfOneNumberGivesThatNumber() {
    assertThat(value(.25, 1, .5, .5)).isEqualTo(.5);
    assertThat(value(.75, 1, .5, .5)).isEqualTo(.5);
  }

  @Test
  void theRangeMustNotBeEmpty() {
    assertThatThrownBy(() -> value(1, 1, 2, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("min and max: expected a range, found 2.0 to 1.0");
    assertThatThrownBy(() -> value(1, Double.NaN, 0, 1))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
