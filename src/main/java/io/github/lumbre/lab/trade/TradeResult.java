package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.render.stopping.NoiseEstimate;
import java.util.List;
import java.util.Optional;

/**
 * The results of a study.
 *
 * @param reference reference picture
 * @param referenceSamples samples per pixel of the reference
 * @param referenceNoise noise of the reference itself
 * @param rows results by setting and number of samples
 * @param exact settings that change only the time
 */
public record TradeResult(
    Image reference,
    int referenceSamples,
    NoiseEstimate referenceNoise,
    List<TradeRow> rows,
    List<ExactRow> exact) {
  /** Returns the rows of the baseline, by number of samples. */
  public List<TradeRow> usual() {
    return of(rows.get(0).setting());
  }

  /** Returns the rows of a setting, by number of samples. */
  public List<TradeRow> of(TradeSetting setting) {
    return rows.stream().filter(row -> row.setting() == setting).toList();
  }

  /** Returns the settings of a kind, in the order of the study. */
  public List<TradeSetting> settings(TradeSetting.Kind kind) {
    return rows.stream()
        .map(TradeRow::setting)
        .filter(setting -> setting.kind() == kind)
        .distinct()
        .toList();
  }

  /** Returns what the baseline measured at a number of samples. */
  public TradeRow usual(int samples) {
    return usual().stream().filter(row -> row.samples() == samples).findFirst().orElseThrow();
  }

  /** Returns the row of a setting with the most samples. */
  public TradeRow most(TradeSetting setting) {
    List<TradeRow> own = of(setting);
    return own.get(own.size() - 1);
  }

  /** Returns the number of seeds of each setting. */
  public int seeds() {
    return rows.get(0).seeds().size();
  }

  /**
   * Returns the efficiency of a row's setting relative to the baseline for the same CPU time. It is
   * the ratio of squared error × time. Empty if renders are too short for the CPU clock.
   */
  public Optional<Interval> gain(TradeRow row) {
    TradeRow usual = usual(row.samples());
    return usual.isTimed() && row.isTimed()
        ? Optional.of(
            Interval.ofRatios(
                usual.times(s -> s.cost().cpuSeconds()), row.times(s -> s.cost().cpuSeconds())))
        : Optional.empty();
  }

  /**
   * Returns the relative efficiency for the same number of rays; it is independent of the machine.
   */
  public Interval gainByRays(TradeRow row) {
    TradeRow usual = usual(row.samples());
    return Interval.ofRatios(
        usual.times(seed -> usual.work().allRays()), row.times(seed -> row.work().allRays()));
  }

  /**
   * Returns whether another row of the same kind dominates a row: it has at most its CPU time and
   * error, and less of at least one.
   */
  public boolean isDominated(TradeRow row) {
    double time = row.cpuTime().value();
    double error = row.relativeMse().value();
    return rows.stream()
        .filter(other -> other.setting().kind() == row.setting().kind())
        .anyMatch(
            other ->
                other.cpuTime().value() <= time
                    && other.relativeMse().value() <= error
                    && (other.cpuTime().value() < time || other.relativeMse().value() < error));
  }
}
