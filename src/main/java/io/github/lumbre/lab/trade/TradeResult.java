package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.stopping.NoiseEstimate;
import java.util.List;
import java.util.Optional;

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
  /** Returns the rows of the setting that is taken for the truth, by number of samples. */
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

  /** Returns the row of a setting with the most samples. */
  public TradeRow most(TradeSetting setting) {
    List<TradeRow> own = of(setting);
    return own.get(own.size() - 1);
  }

  /** Returns how many seeds each setting was rendered with. */
  public int seeds() {
    return rows.get(0).errors().size();
  }

  /**
   * Returns how many times as far as the usual setting another gets in the same processor time: the
   * ratio of squared error times time, at the most samples of the other. Empty if renders are too
   * short for the processor's clock.
   */
  public Optional<Interval> gain(TradeSetting setting) {
    TradeRow most = most(setting);
    TradeRow usual = usual(most.samples());
    return usual.isTimed() && most.isTimed()
        ? Optional.of(Interval.ofRatios(usual.costs(), most.costs()))
        : Optional.empty();
  }

  /** Returns the same gain for as many rays instead of time: it is that of every machine. */
  public Interval gainByRays(TradeSetting setting) {
    TradeRow most = most(setting);
    return Interval.ofRatios(usual(most.samples()).costsInRays(), most.costsInRays());
  }

  private TradeRow usual(int samples) {
    return usual().stream().filter(row -> row.samples() == samples).findFirst().orElseThrow();
  }

  /**
   * Tells whether another row of the same kind of knob takes no more processor time and has no more
   * error, and less of one of them.
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
