package io.github.lumbre.render.stopping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Tests the forecast of the samples that an error needs. */
class ForecastTest {
  private static NoiseEstimate bound(double relativeMse) {
    return new NoiseEstimate(relativeMse / 2, relativeMse, .95, 0, 1000);
  }

  @Test
  void independentSamplesTakeMostAndSmoothOnesLeast() {
    // Eight times the squared error needs 8 times the samples, or 8^(2/3) times.
    Forecast forecast = Forecast.of(bound(8 * .02 * .02), 32, .02);
    assertThat(forecast.most()).isCloseTo(8 * 32, within(1e-9));
    assertThat(forecast.least()).isCloseTo(4 * 32, within(1e-9));
    assertThat(forecast.likely()).isBetween(forecast.least(), forecast.most());
  }

  @Test
  void whatIsReachedTakesNoMore() {
    assertThat(Forecast.of(bound(1e-6), 32, .02)).isEqualTo(new Forecast(32, 32));
  }
}
