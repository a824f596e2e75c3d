package io.github.lumbre.cli.output;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.internal.DepthCut;
import io.github.lumbre.scenefile.SceneFile;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Reports the bias of a picture: energy that it loses with any number of samples.
 *
 * @param cut energy lost to the path length limit; empty if it was not estimated
 * @param clamp largest component of a sample; infinite if samples are not clamped
 * @param clamped number of clamped samples
 * @param clampedShare share of the energy of all samples that clamping removed
 */
public record LightReport(Optional<DepthCut> cut, double clamp, long clamped, double clampedShare) {
  /** The largest share of a render's time that the estimate may take. */
  private static final double LARGEST_COST = .01;

  /** Returns the report on a finished film that was rendered in one run. */
  public static LightReport of(
      SceneFile file, Film film, RenderStatistics statistics, boolean isQuiet)
      throws InterruptedException {
    boolean isCheap = film.totalSamples() * LARGEST_COST > DepthCut.COST_IN_SAMPLES;
    Optional<DepthCut> cut =
        isCheap && !isQuiet
            ? Optional.of(DepthCut.of(file.scene(), file.settings()))
            : Optional.empty();
    double lost = statistics.clampedLight();
    double share = lost > 0 ? lost / (lost + film.totalLight()) : 0;
    return new LightReport(cut, file.settings().clamp(), statistics.clamped(), share);
  }

  private boolean isClamped() {
    return clamp < Double.POSITIVE_INFINITY;
  }

  /** Prints one line for each loss that is known. */
  public void print(Messages messages) {
    cut.ifPresent(c -> messages.line("energy lost to the path length limit: " + text(c)));
    if (isClamped()) {
      messages.line("energy lost to clamping: " + clampedText());
    }
  }

  private static String text(DepthCut cut) {
    double high = cut.share() + 2 * cut.standardError();
    return cut.share() > 2 * cut.standardError()
        ? String.format(
            Locale.ROOT, "about %.2g %% (± %.1g)", 100 * cut.share(), 100 * cut.standardError())
        : String.format(Locale.ROOT, "less than %.1g %%", 100 * Math.max(high, 1e-4));
  }

  private String clampedText() {
    return String.format(
        Locale.ROOT,
        "%.2g %%, in %s above %s",
        100 * clampedShare,
        Numbers.count(clamped, "sample"),
        clamp);
  }

  /** Adds the metadata for the picture's file. */
  public void putInto(Map<String, String> metadata) {
    cut.ifPresent(c -> metadata.put("LightBeyondDepth", text(c)));
    if (isClamped()) {
      metadata.put("LightClamped", clampedText());
    }
  }

  /** Adds the values to the JSON summary. */
  public void putInto(JsonSummary report) {
    cut.ifPresent(
        c -> {
          Map<String, Object> values = new LinkedHashMap<>();
          values.put("share", c.share());
          values.put("standard_error", c.standardError());
          report.put("light_beyond_depth", values);
        });
    if (isClamped()) {
      Map<String, Object> values = new LinkedHashMap<>();
      values.put("to", clamp);
      values.put("samples", clamped);
      values.put("share", clampedShare);
      report.put("light_clamped", values);
    }
  }
}
