package io.github.lumbre.cli.output;

import io.github.lumbre.render.stopping.Forecast;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * An early forecast of the samples and time that a target error takes, and of whether the render
 * reaches it.
 *
 * @param secondsPerSample mean time so far for one sample of every pixel
 * @param samples limit of samples per pixel
 * @param secondsInAll time limit since the start of the render; empty if there is none
 */
public record ForecastReport(
    Forecast forecast, double secondsPerSample, int samples, OptionalDouble secondsInAll) {
  /** Returns the forecast as a line of text. */
  public String line() {
    return String.format(
        Locale.ROOT,
        "forecast: the target error takes about %.0f samples per pixel (%.0f to %.0f), %s (%s to"
            + " %s)%s",
        forecast.likely(),
        forecast.least(),
        forecast.most(),
        time(forecast.likely()),
        time(forecast.least()),
        time(forecast.most()),
        verdict());
  }

  /** Returns a note if samples or time will or may end the render before the target error. */
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
