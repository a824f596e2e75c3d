package io.github.lumbre.measure;

import io.github.lumbre.image.Image;
import java.util.List;

/**
 * What a study found.
 *
 * @param reference that all is compared with
 * @param referenceSamples per pixel
 * @param referenceNoise of the reference itself
 * @param rows by setting, and for each by number of samples
 * @param exact settings that change the time alone
 */
public record TradeResult(
    Image reference,
    int referenceSamples,
    NoiseEstimate referenceNoise,
    List<TradeRow> rows,
    List<ExactRow> exact) {
  /**
   * Tells whether another row takes no more processor time and has no more error, and less of one
   * of them.
   *
   * @param others that it is compared with
   */
  public static boolean isDominated(TradeRow row, List<TradeRow> others) {
    double time = row.cpuTime().value();
    double error = row.relativeMse().value();
    return others.stream()
        .anyMatch(
            other ->
                other.cpuTime().value() <= time
                    && other.relativeMse().value() <= error
                    && (other.cpuTime().value() < time || other.relativeMse().value() < error));
  }
}
