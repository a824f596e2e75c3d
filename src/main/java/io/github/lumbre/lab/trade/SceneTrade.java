package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import java.util.Map;

/**
 * The results of a study of one scene that tables of several scenes need.
 *
 * @param scene name of the scene
 * @param width width of the frame in pixels
 * @param height height of the frame in pixels
 * @param seeds number of seeds of each setting
 * @param referenceSamples samples per pixel of the reference
 * @param referenceRmse relative RMSE of the reference itself
 * @param facts facts about the run, by name
 * @param rows results by setting, the baseline first, and by number of samples
 */
public record SceneTrade(
    String scene,
    int width,
    int height,
    int seeds,
    int referenceSamples,
    double referenceRmse,
    Map<String, String> facts,
    List<Row> rows) {
  public SceneTrade {
    facts = Map.copyOf(facts);
    rows = List.copyOf(rows);
    if (rows.isEmpty()) {
      throw new IllegalArgumentException("rows: expected some, found none");
    }
  }

  /**
   * A setting at a number of samples.
   *
   * @param isUnbiased whether the setting is unbiased
   * @param cost error and time of each seed
   * @param work work per sample
   * @param bias bias, estimated from all seeds
   */
  public record Row(
      String knob,
      String value,
      boolean isUnbiased,
      TimeToError.Cost cost,
      TradeWork work,
      TradeRow.Bias bias) {
    String label() {
      return TradeText.label(knob, value);
    }

    double rays() {
      return work.rays() + work.shadowRays();
    }

    private List<Double> costsInRays() {
      return cost.relativeMse().stream().map(e -> e * rays()).toList();
    }
  }

  /** Returns the rows of a setting; empty if it was not measured. */
  List<Row> of(String label) {
    return rows.stream().filter(row -> row.label().equals(label)).toList();
  }

  /** Returns the rows of the baseline. */
  List<Row> usual() {
    return of(rows.get(0).label());
  }

  /** Returns the row with the most samples, given the rows of one setting. */
  static Row most(List<Row> own) {
    return own.get(own.size() - 1);
  }

  /** Returns the errors and times of the baseline, without the reference's own noise. */
  List<TimeToError.Cost> usualCosts() {
    double noise = referenceRmse * referenceRmse;
    return usual().stream().map(row -> row.cost().less(noise)).toList();
  }

  /** Returns the cost of reaching an error with the baseline. */
  TimeToError toError(double relativeMse) {
    return TimeToError.of(usualCosts(), relativeMse);
  }

  /** Returns whether the reference is accurate enough to measure such an error. */
  boolean canTell(double relativeMse) {
    return referenceRmse * referenceRmse <= relativeMse / TradePlan.REFERENCE_MARGIN;
  }

  /**
   * Returns the efficiency of a setting relative to the baseline with the same number of rays, at
   * the setting's largest number of samples.
   */
  Interval gainByRays(List<Row> other) {
    Row most = most(other);
    Row same =
        usual().stream()
            .filter(row -> row.cost().samples() == most.cost().samples())
            .findFirst()
            .orElseThrow();
    return Interval.ofRatios(same.costsInRays(), most.costsInRays());
  }

  long pixels() {
    return (long) width * height;
  }
}
