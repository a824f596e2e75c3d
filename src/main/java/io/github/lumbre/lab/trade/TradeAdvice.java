package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.trade.Html.Row;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The section of a study's page that recommends settings for a target error. */
final class TradeAdvice {
  /** Target errors of the table, relative root mean squared errors. */
  private static final double[] TARGETS = {.5, .3, .2, .1, .05, .03, .02, .01};

  private static final String GROUPS =
      "<tr><th></th><th class=\"group\" colspan=\"4\">bias not detected</th>"
          + "<th class=\"group\" colspan=\"4\">bias allowed</th></tr>";

  private TradeAdvice() {}

  /** Adds the table to a page. */
  static void addTo(Html html, TradeResult result) {
    html.element("h2", "Recommended settings for a target error");
    List<Row> rows = new ArrayList<>();
    for (double target : TARGETS) {
      List<String> cells = new ArrayList<>(List.of(Markdown.percent(target)));
      cells.addAll(unbiased(result, target));
      cells.addAll(biased(result, target));
      rows.add(new Row(cells, ""));
    }
    html.table(
            GROUPS,
            List.of(
                "target error",
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
            "Error: relative RMSE against the reference, including noise and bias, mean over the"
                + " seeds. Each entry is the setting with the least CPU time among those with"
                + " flags. Left: unbiased settings (bias: none), and settings whose bias was not"
                + " detected and is at most the target error with 95 % confidence (bias: < that"
                + " bound). Their times are interpolated between measured numbers of samples."
                + " Extrapolated: no measured setting reaches the error; the squared error is"
                + " assumed inversely proportional to the samples. Right: the measured settings"
                + " with bias. Errors below the reference's own cannot be measured.");
  }

  /** A setting and its cost of reaching an error. */
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
   * Returns the cheapest setting with flags that is unbiased, or whose bias is not detected and at
   * most the target error. Settings that were measured to reach the error precede extrapolated
   * ones.
   */
  private static Choice cheapest(TradeResult result, double target) {
    double squared = target * target;
    return Stream.of(Kind.NOISE, Kind.BIAS)
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

  /** Returns flags, time, rays and bias of the cheapest measured row with bias. */
  private static List<String> biased(TradeResult result, double target) {
    Optional<TradeRow> best =
        result.rows().stream()
            .filter(row -> !row.setting().isUnbiased() && !row.setting().flags().isEmpty())
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
