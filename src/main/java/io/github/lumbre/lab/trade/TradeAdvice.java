package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.trade.Html.Row;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The part of a study's page that answers what to set for a wanted error. */
final class TradeAdvice {
  /** Errors that a reader may want, as relative root mean squared errors. */
  private static final double[] TARGETS = {.5, .3, .2, .1, .05, .03, .02, .01};

  private static final String GROUPS =
      "<tr><th></th><th class=\"group\" colspan=\"4\">bias not detected</th>"
          + "<th class=\"group\" colspan=\"4\">bias allowed</th></tr>";

  private TradeAdvice() {}

  /** Adds the table to a page. */
  static void addTo(Html html, TradeResult result) {
    html.element("h2", "For this error pick these settings");
    List<Row> rows = new ArrayList<>();
    for (double target : TARGETS) {
      List<String> cells = new ArrayList<>(List.of(TradeText.percent(target)));
      cells.addAll(unbiased(result, target));
      cells.addAll(biased(result, target));
      rows.add(new Row(cells, ""));
    }
    html.table(
            GROUPS,
            List.of(
                "error wanted",
                "flags",
                "CPU time",
                "rays",
                "bias",
                "flags",
                "CPU time",
                "rays",
                "bias"),
            rows)
        .note(
            "Error: relative RMSE against the reference, noise and bias together, mean over the"
                + " seeds. Each entry is the cheapest in CPU time of the settings that have flags."
                + " On the left are settings without bias (bias: none), and those whose bias was"
                + " not detected and is at most the wanted error with 95 % confidence (bias: < that"
                + " bound). Times there are interpolated between measured numbers of samples."
                + " Extrapolated: no measured setting reaches the error, and the squared error is"
                + " taken to be inversely proportional to the samples. On the right is any measured"
                + " setting with bias. Errors below the reference's own cannot be measured.");
  }

  /** What a setting takes to reach an error. */
  private record Choice(TradeRow most, TimeToError cost) {
    double cpuSeconds() {
      return cost.cpuSeconds().value();
    }
  }

  /** Returns flags, time, rays and bias of the cheapest setting whose bias is not detected. */
  private static List<String> unbiased(TradeResult result, double target) {
    Choice best = cheapest(result, target);
    TradeRow most = best.most;
    double samples = Math.max(1, best.cost.samples().value());
    double raysOfOne = most.allRays() / most.samples();
    return List.of(
        "-s " + Math.round(Math.ceil(samples)) + " " + most.setting().flags(),
        (best.cost.isExtrapolated() ? "extrapolated " : "about ")
            + TradeText.seconds(best.cpuSeconds()),
        TradeText.count(samples * raysOfOne),
        most.setting().isUnbiased() ? "none" : "< " + TradeText.rootPercent(most.bias().high()));
  }

  /**
   * Returns the cheapest setting with flags that is without bias, or whose bias is not detected and
   * at most the wanted error. A setting that was measured to reach the error goes before all that
   * would have to be extrapolated.
   */
  private static Choice cheapest(TradeResult result, double target) {
    double squared = target * target;
    return Stream.of(Kind.values())
        .flatMap(kind -> result.settings(kind).stream())
        .filter(setting -> !setting.flags().isEmpty())
        .map(result::most)
        .filter(most -> most.setting().isUnbiased() || isWithin(most.bias(), squared))
        .map(most -> new Choice(most, TimeToError.of(costs(result, most), squared)))
        .min(
            Comparator.comparing((Choice choice) -> choice.cost.isExtrapolated())
                .thenComparingDouble(Choice::cpuSeconds))
        .orElseThrow();
  }

  private static List<TimeToError.Cost> costs(TradeResult result, TradeRow most) {
    return result.of(most.setting()).stream().map(TradeRow::cost).toList();
  }

  private static boolean isWithin(TradeRow.Bias bias, double squaredError) {
    return !bias.isDetected() && bias.high() <= squaredError;
  }

  /** Returns settings, time, rays and bias of the measured row that costs least. */
  private static List<String> biased(TradeResult result, double target) {
    Optional<TradeRow> best =
        result.rows().stream()
            .filter(row -> row.setting().kind() == Kind.BIAS && !row.setting().flags().isEmpty())
            .filter(row -> row.relativeMse().value() <= target * target)
            .min(Comparator.comparingDouble(row -> row.cpuTime().value()));
    return best.map(
            row ->
                List.of(
                    "-s " + row.samples() + " " + row.setting().flags(),
                    TradeText.seconds(row.cpuTime().value()),
                    TradeText.count(row.allRays()),
                    (row.bias().isDetected() ? "" : "< ")
                        + TradeText.rootPercent(
                            row.bias().isDetected() ? row.bias().squared() : row.bias().high())))
        .orElse(List.of("not reached", "", "", ""));
  }
}
