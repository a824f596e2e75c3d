package io.github.lumbre.measure;

import io.github.lumbre.measure.Html.Row;
import io.github.lumbre.measure.TradeSetting.Kind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** The part of a study's page that answers what to set for a wanted error. */
final class TradeAdvice {
  /** Errors that a reader may want, as relative root mean squared errors. */
  private static final double[] TARGETS = {.5, .3, .2, .1, .05, .03, .02, .01};

  private static final String GROUPS =
      "<tr><th></th><th class=\"group\" colspan=\"3\">without bias</th>"
          + "<th class=\"group\" colspan=\"4\">if light may be left out</th></tr>";

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
                "settings",
                "CPU time",
                "rays",
                "settings",
                "CPU time",
                "rays",
                "of it bias"),
            rows)
        .note(
            "Error: relative RMSE against the reference, noise and bias together, mean over the"
                + " seeds. A time is between measured numbers of samples, or beyond them where it"
                + " says so, where the squared error is taken to be inverse to the samples. Errors"
                + " below the reference's own cannot be told.");
  }

  /** Returns settings, time and rays of the usual setting with as many samples as it takes. */
  private static List<String> unbiased(TradeResult result, double target) {
    List<TradeRow> rows = result.usual();
    TimeToError cost = TimeToError.of(rows.stream().map(TradeRow::cost).toList(), target * target);
    TradeRow first = rows.get(0);
    double samples = Math.max(1, cost.samples().value());
    double raysOfOne = first.allRays() / first.samples();
    return List.of(
        "-s " + Math.round(Math.ceil(samples)) + " " + first.setting().flags(),
        (cost.isExtrapolated() ? "extrapolated " : "about ")
            + TradeText.seconds(cost.cpuSeconds().value()),
        TradeText.count(samples * raysOfOne));
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
