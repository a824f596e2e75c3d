package io.github.lumbre.cli.output;

import io.github.lumbre.stopping.Forecast;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * What is told early of how long an error will take, and of whether the render will go on so long.
 *
 * @param secondsPerSample what a sample of each pixel has taken so far
 * @param samples per pixel at which the render ends
 * @param secondsInAll after which the render ends, from its beginning; empty if no time ends it
 */
public record ForecastReport(
    Forecast forecast, double secondsPerSample, int samples, OptionalDouble secondsInAll) {
  /** Returns a line for people. */
  public String line() {
    return String.format(
        Locale.ROOT,
        "forecast: the error takes about %.0f samples per pixel (%.0f to %.0f), %s (%s to %s)%s",
        forecast.likely(),
        forecast.least(),
        forecast.most(),
        time(forecast.likely()),
        time(forecast.least()),
        time(forecast.most()),
        verdict());
  }

  /** Tells whether samples or time end the render before the error is reached. */
  private String verdict() {
    if (endsBefore(forecast.least())) {
      return "; it will not be reached";
    }
    return endsBefore(forecast.most()) ? "; it may not be reached" : "";
  }

  private boolean endsBefore(double wanted) {
    return wanted > samples || wanted * secondsPerSample > secondsInAll.orElse(Double.MAX_VALUE);
  }

  private String time(double wanted) {
    double seconds = wanted * secondsPerSample;
    if (seconds < 10) {
      return String.format(Locale.ROOT, "%.2g s", seconds);
    }
    if (seconds < 120) {
      return String.format(Locale.ROOT, "%.0f s", seconds);
    }
    if (seconds < 7200) {
      return String.format(Locale.ROOT, "%.0f min", seconds / 60);
    }
    return String.format(Locale.ROOT, "%.0f h", seconds / 3600);
  }
}
