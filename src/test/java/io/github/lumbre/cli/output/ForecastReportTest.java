package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.stopping.Forecast;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

/** Tests the text of forecasts. */
class ForecastReportTest {
  private static final Forecast FORECAST = new Forecast(100, 400);

  private static String line(double secondsPerSample, int samples, OptionalDouble secondsInAll) {
    return new ForecastReport(FORECAST, secondsPerSample, samples, secondsInAll).line();
  }

  @Test
  void samplesAndTimesHaveIntervals() {
    assertThat(line(.5, 1 << 30, OptionalDouble.empty()))
        .isEqualTo(
            "forecast: the target error takes about 200 samples per pixel (100 to 400),"
                + " 100 s (50 s to 3 min)");
    assertThat(line(.01, 1 << 30, OptionalDouble.empty())).endsWith(" 2.0 s (1.0 s to 4.0 s)");
    assertThat(line(60, 1 << 30, OptionalDouble.empty())).endsWith(" 3 h (100 min to 7 h)");
  }

  @Test
  void whatCannotBeReachedIsSaid() {
    assertThat(line(.5, 99, OptionalDouble.empty())).endsWith("; it will not be reached");
    assertThat(line(.5, 399, OptionalDouble.empty())).endsWith("; it may not be reached");
    assertThat(line(.5, 400, OptionalDouble.of(201))).endsWith("min)");
    assertThat(line(.5, 400, OptionalDouble.of(199))).endsWith("; it may not be reached");
    assertThat(line(.5, 400, OptionalDouble.of(49))).endsWith("; it will not be reached");
  }
}
