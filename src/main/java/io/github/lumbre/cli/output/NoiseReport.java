package io.github.lumbre.cli.output;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.stopping.NoiseEstimate;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Reports a picture's samples and noise.
 *
 * @param noise estimate of the noise; empty if it is not known
 * @param target target error, if one was given
 * @param end what ended the render: {@code samples}, {@code time} or {@code error}
 */
public record NoiseReport(
    Film film,
    Optional<NoiseEstimate> noise,
    OptionalDouble target,
    boolean reachedTarget,
    String end) {
  /**
   * Returns {@code 64 samples per pixel}, or {@code 32 to 64 (median 64, mean 50.1) samples per
   * pixel} if they differ between pixels.
   */
  String perPixel() {
    return Summary.perPixel(samples());
  }

  /**
   * Returns the samples per pixel: {@code 64}, or {@code 32 to 64 (median 64, mean 50.1)} if they
   * differ between pixels.
   */
  String samples() {
    int fewest = film.fewestSamples();
    int most = film.mostSamples();
    return fewest == most
        ? String.valueOf(most)
        : String.format(
            Locale.ROOT,
            "%d to %d (median %d, mean %.4g)",
            fewest,
            most,
            film.medianSamples(),
            film.meanSamples());
  }

  /** Returns {@code , noise about 1.6 % (at most 1.8 %)}; empty if the noise is not known. */
  String line() {
    return noise
        .map(n -> ", noise about %s (%s)".formatted(Numbers.percent(n.relativeRmse()), bound(n)))
        .orElse("");
  }

  private static String bound(NoiseEstimate noise) {
    return Double.isInfinite(noise.upperRelativeMse())
        ? "no bound: too few pixels"
        : "at most " + Numbers.percent(noise.upperRelativeRmse());
  }

  /** Prints warnings about a bound that may not hold and a missed target error. */
  public void printDoubts(Messages messages) {
    noise.filter(NoiseEstimate::isDoubtful).map(NoiseReport::doubt).ifPresent(messages::warning);
    if (isMissed()) {
      messages.line(
          "warning: the target error of "
              + Numbers.percent(target.getAsDouble())
              + " is not reached"
              + noise.map(n -> ": " + bound(n)).orElse(""));
    }
  }

  /** Returns why the bound of a doubtful estimate may not hold. */
  public static String doubt(NoiseEstimate noise) {
    return "few bright samples carry %s of the noise, so its bound may not hold; take more samples"
        .formatted(Numbers.percent(noise.outlierShare()));
  }

  /** Returns whether a target error was given but not reached. */
  public boolean isMissed() {
    return target.isPresent() && !reachedTarget;
  }

  /** Adds the metadata for the picture's file. */
  public void putInto(Map<String, String> metadata) {
    metadata.put(PictureMetadata.SAMPLES, samples());
    target.ifPresent(t -> metadata.put(PictureMetadata.TARGET_ERROR, Numbers.percent(t)));
    noise.ifPresent(
        n -> {
          metadata.put("Noise", Numbers.percent(n.relativeRmse()));
          metadata.put(
              "NoiseBound", bound(n) + " with a confidence of " + Numbers.percent(n.confidence()));
          if (n.isDoubtful()) {
            metadata.put("NoiseDoubt", doubt(n));
          }
        });
  }

  /** Adds the values to the JSON summary. */
  public void putInto(JsonSummary report) {
    Map<String, Object> samples = new LinkedHashMap<>();
    samples.put("min", film.fewestSamples());
    samples.put("median", film.medianSamples());
    samples.put("mean", film.meanSamples());
    samples.put("max", film.mostSamples());
    report.put("pixel_samples", samples);
    report.put("ended_by", end);
    noise.ifPresent(
        n -> {
          Map<String, Object> values = new LinkedHashMap<>();
          values.put("relative_rmse", n.relativeRmse());
          if (Double.isFinite(n.upperRelativeMse())) {
            values.put("at_most", n.upperRelativeRmse());
          }
          values.put("confidence", n.confidence());
          values.put("outlier_share", n.outlierShare());
          if (n.isDoubtful()) {
            values.put("doubt", doubt(n));
          }
          report.put("noise", values);
        });
    target.ifPresent(
        t -> {
          report.put("target_error", t);
          report.put("target_reached", reachedTarget);
        });
  }
}
