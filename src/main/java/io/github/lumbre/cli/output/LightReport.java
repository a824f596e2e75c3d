package io.github.lumbre.cli.output;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.render.DepthCut;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderStatistics;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * What is told of light that a picture lacks whatever the number of samples.
 *
 * @param cut beyond the greatest depth; empty if that was not estimated
 * @param clamp to which samples were darkened; infinite for none
 * @param clamped how many samples were
 * @param clampedShare of the light of all samples
 */
public record LightReport(Optional<DepthCut> cut, double clamp, long clamped, double clampedShare) {
  /** The estimate is to take less than this of a render's time. */
  private static final double LARGEST_COST = .01;

  /** Returns what is to be told of a film that is done, rendered in one run. */
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

  /** Prints a line for each kind of light that is estimated. */
  public void print(Messages messages) {
    cut.ifPresent(c -> messages.line("light beyond the depth: " + text(c)));
    if (isClamped()) {
      messages.line("light clamped: " + clampedText());
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
        Locale.ROOT, "%.2g %%, of %d samples above %s", 100 * clampedShare, clamped, clamp);
  }

  /** Adds what the picture's file is to tell. */
  public void putInto(Map<String, String> metadata) {
    cut.ifPresent(c -> metadata.put("LightBeyondDepth", text(c)));
    if (isClamped()) {
      metadata.put("LightClamped", clampedText());
    }
  }

  /** Adds what programs are to hear. */
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
