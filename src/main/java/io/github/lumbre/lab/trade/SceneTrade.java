package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.metrics.Interval;
import java.util.List;
import java.util.Map;

/**
 * What a study of one scene found, as far as tables of several scenes need it.
 *
 * @param scene its name
 * @param width of the frame in pixels
 * @param height of the frame in pixels
 * @param seeds of each setting
 * @param referenceSamples per pixel
 * @param referenceRmse relative, of the reference itself
 * @param facts of the run, by name, as its page tells them
 * @param rows by setting, that which was taken for the truth first, and by number of samples
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
   * @param isUnbiased whether the setting keeps the truth
   * @param cost of each seed
   * @param work of one sample
   * @param bias of all seeds together
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

  /** Returns the rows of the setting that was taken for the truth. */
  List<Row> usual() {
    return of(rows.get(0).label());
  }

  /** Returns the row with the most samples of rows of one setting. */
  static Row most(List<Row> own) {
    return own.get(own.size() - 1);
  }

  /** Returns what the truth costs and brings, the reference's own noise taken off. */
  List<TimeToError.Cost> usualCosts() {
    double noise = referenceRmse * referenceRmse;
    return usual().stream().map(row -> row.cost().less(noise)).toList();
  }

  /** Returns what the truth takes to an error. */
  TimeToError toError(double relativeMse) {
    return TimeToError.of(usualCosts(), relativeMse);
  }

  /** Tells whether the reference is near enough to the truth for such errors to be measured. */
  boolean canTell(double relativeMse) {
    return referenceRmse * referenceRmse <= relativeMse / TradePlan.REFERENCE_MARGIN;
  }

  /**
   * Returns how many times as far as the usual setting another gets with as many rays, at the most
   * samples of the other.
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
