package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings;
import org.junit.jupiter.api.Test;

/** Tests which samples are rejected and clamped. */
class SampleLimitTest {
  private static final SampleLimit LIMIT =
      SampleLimit.of(new RenderSettings.Builder().clamp(2).build());

  @Test
  void samplesUpToTheClampAreKept() {
    for (Rgb kept : new Rgb[] {Rgb.BLACK, new Rgb(2, 1, .5), new Rgb(0, 2, 0), Rgb.gray(2)}) {
      assertThat(LIMIT.isClamped(kept)).isFalse();
      assertThat(LIMIT.apply(kept)).isEqualTo(kept);
    }
  }

  /** The largest component becomes the clamp, and the ratios of the components stay. */
  @Test
  void brighterSamplesKeepTheirHue() {
    for (Rgb bright : new Rgb[] {new Rgb(8, 4, 2), new Rgb(1, 2.5, 0), new Rgb(0, 1, 1e300)}) {
      assertThat(LIMIT.isClamped(bright)).isTrue();
      Rgb found = LIMIT.apply(bright);
      assertThat(found.max()).isCloseTo(2, within(1e-15));
      assertThat(found.r() * bright.max()).isCloseTo(bright.r() * 2, within(1e-12));
      assertThat(found.g() / found.max()).isCloseTo(bright.g() / bright.max(), within(1e-15));
    }
    assertThat(LIMIT.isClamped(Rgb.gray(Math.nextUp(2.0)))).isTrue();
  }

  @Test
  void withoutAClampAllFiniteSamplesAreKept() {
    SampleLimit none = SampleLimit.of(RenderSettings.DEFAULT);
    Rgb bright = new Rgb(1e300, 3, 1);
    assertThat(none.isClamped(bright)).isFalse();
    assertThat(none.apply(bright)).isEqualTo(bright);
  }

  /** One bad component rejects the sample; rejected samples are black and not clamped. */
  @Test
  void samplesThatAreNegativeOrNotFiniteAreRejected() {
    for (double bad : new double[] {-1e-300, -5, Double.NaN, Double.POSITIVE_INFINITY, -1 / 0.0}) {
      for (Rgb sample : new Rgb[] {new Rgb(bad, 9, 9), new Rgb(9, bad, 9), new Rgb(9, 9, bad)}) {
        assertThat(SampleLimit.isRejected(sample)).isTrue();
        assertThat(LIMIT.isClamped(sample)).isFalse();
        assertThat(LIMIT.apply(sample)).isEqualTo(Rgb.BLACK);
      }
    }
    assertThat(SampleLimit.isRejected(Rgb.BLACK)).isFalse();
    assertThat(SampleLimit.isRejected(new Rgb(-0.0, 0, 1e300))).isFalse();
  }
}
