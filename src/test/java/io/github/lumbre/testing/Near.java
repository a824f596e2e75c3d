package io.github.lumbre.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/** Checks of vectors and colors that are equal but for rounding. */
public final class Near {
  private Near() {}

  /** Checks that the distance of two points is below an error. */
  public static void assertNear(Vec3 found, Vec3 expected, double error) {
    assertThat(found.minus(expected).length()).as("%s", found).isLessThan(error);
  }

  /** Checks that each channel is within an error. */
  public static void assertNear(Rgb found, Rgb expected, double error) {
    assertThat(found.r()).as("%s", found).isCloseTo(expected.r(), within(error));
    assertThat(found.g()).as("%s", found).isCloseTo(expected.g(), within(error));
    assertThat(found.b()).as("%s", found).isCloseTo(expected.b(), within(error));
  }
}
