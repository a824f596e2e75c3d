package io.github.lumbre.lab.trade;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.lab.Table;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** The section of a study's page that recommends settings for a target error. */
final class TradeAdvice {
  /** Target errors of the table, relative root mean squared errors. */
  private static final List<Double> TARGETS = List.of(.5, .3, .2, .1, .05, .03, .02, .01);

  private static final String GROUPS =
      "<tr><th></th><th class=\"group\" colspan=\"4\">bias not detected</th>"
          + "<th class=\"group\" colspan=\"4\">bias allowed</th></tr>";

  private static final Choice NONE = new Choice("not reached", "", "", "");

  private TradeAdvice() {}

  /** A recommended setting, as text. */
  private record Choice(String flags, String time, String rays, String bias) {}

  /** Adds the table to a page. */
  static void addTo(Html html, TradeResult result) {
    Table<Double> table = Table.<Double>empty().text("target error", Numbers::percent);
    table = with(table, target -> unbiased(result, target));
    table = with(table, target -> biased(result, target).orElse(NONE));
    html.element("h2", "Recommended settings for a target error")
        .table(GROUPS, table, TARGETS, target -> "")
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

  private static Table<Double> with(Table<Double> table, Function<Double, Choice> choice) {
    return table
        .text("flags", target -> choice.apply(target).flags)
        .number("CPU time", target -> choice.apply(target).time)
        .number("rays", target -> choice.apply(target).rays)
        .number("bias", target -> choice.apply(target).bias);
  }

  /** A setting's row with the most samples, and its cost of reaching an error. */
  private record Candidate(TradeRow most, TimeToError cost) {
    double cpuSeconds() {
      return cost.cpuSeconds().value();
    }
  }

  /** Returns the cheapest setting whose bias is not detected. */
  private static Choice unbiased(TradeResult result, double target) {
    Candidate best = cheapest(result, target * target);
    TradeRow most = best.most;
    double samples = Math.max(1, best.cost.samples().value());
    return new Choice(
        "-s " + Math.round(Math.ceil(samples)) + " " + most.setting().flags(),
        (best.cost.isExtrapolated() ? "extrapolated " : "about ")
            + TradeText.seconds(best.cpuSeconds()),
        Numbers.large(samples * most.allRays() / most.samples()),
        most.setting().isUnbiased() ? "none" : TradeText.bias(most.bias(), ""));
  }

  /**
   * Returns the cheapest setting with flags that is unbiased, or whose bias is not detected and at
   * most the target error. Settings that were measured to reach the error precede extrapolated
   * ones.
   */
  private static Candidate cheapest(TradeResult result, double squaredError) {
    return Stream.of(Kind.NOISE, Kind.BIAS)
        .flatMap(kind -> result.settings(kind).stream())
        .filter(setting -> !setting.flags().isEmpty())
        .map(result::most)
        .filter(most -> most.setting().isUnbiased() || isWithin(most.bias(), squaredError))
        .map(most -> new Candidate(most, TimeToError.of(costs(result, most), squaredError)))
        .min(
            Comparator.comparing((Candidate candidate) -> candidate.cost.isExtrapolated())
                .thenComparingDouble(Candidate::cpuSeconds))
        .orElseThrow();
  }

  private static List<TimeToError.Cost> costs(TradeResult result, TradeRow most) {
    return result.of(most.setting()).stream().map(TradeRow::cost).toList();
  }

  private static boolean isWithin(TradeRow.Bias bias, double squaredError) {
    return !bias.isDetected() && bias.high() <= squaredError;
  }

  /** Returns the cheapest measured row with bias. */
  private static Optional<Choice> biased(TradeResult result, double target) {
    return result.rows().stream()
        .filter(row -> !row.setting().isUnbiased() && !row.setting().flags().isEmpty())
        .filter(row -> row.relativeMse().value() <= target * target)
        .min(Comparator.comparingDouble(row -> row.cpuTime().value()))
        .map(
            row ->
                new Choice(
                    "-s " + row.samples() + " " + row.setting().flags(),
                    TradeText.seconds(row.cpuTime().value()),
                    Numbers.large(row.allRays()),
                    TradeText.bias(row.bias(), "")));
  }
}
