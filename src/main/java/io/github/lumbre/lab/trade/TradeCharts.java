package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import io.github.lumbre.scene.SettingType;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** The charts of a study: the Pareto front of each kind of setting, and each setting separately. */
record TradeCharts(TradeResult result) {
  private static final String ACROSS = "CPU seconds";
  private static final String UP = "relative RMSE, %";

  /** Returns charts of the unbiased settings. */
  List<LogChart> noise() {
    List<LogChart> charts = new ArrayList<>();
    charts.add(front("Unbiased settings with Pareto front", Kind.NOISE));
    charts.addAll(knobs(Kind.NOISE, Optional.of("baseline")));
    return charts;
  }

  /** Returns charts of the biased settings. */
  List<LogChart> bias() {
    List<LogChart> charts = new ArrayList<>();
    charts.add(front("Biased settings with Pareto front", Kind.BIAS));
    charts.addAll(knobs(Kind.BIAS, Optional.empty()));
    List<LogChart.Series> floors = floors();
    if (!floors.isEmpty()) {
      charts.add(new LogChart("Bias, not reduced by samples", ACROSS, "bias, %", floors));
    }
    return charts;
  }

  /** Returns the chart of denoised pictures beside the baseline. */
  List<LogChart> denoised() {
    return knobs(Kind.DENOISED, Optional.of("noisy"));
  }

  /**
   * Returns a chart for each parameter.
   *
   * @param baseline name of the baseline in the charts; empty to leave it out
   */
  private List<LogChart> knobs(Kind kind, Optional<String> baseline) {
    TradeSetting usual = result.usual().get(0).setting();
    List<TradeSetting> settings =
        result.settings(kind).stream().filter(setting -> setting != usual).toList();
    List<LogChart> charts = new ArrayList<>();
    for (Knob knob : settings.stream().map(TradeSetting::knob).distinct().toList()) {
      List<LogChart.Series> series = new ArrayList<>();
      baseline.ifPresent(name -> series.add(errors(name, result.usual(), true)));
      settings.stream()
          .filter(setting -> setting.knob() == knob)
          .map(setting -> errors(setting.value(), result.of(setting), false))
          .forEach(series::add);
      charts.add(new LogChart(knob.title(), ACROSS, UP, series));
    }
    return charts;
  }

  private static LogChart.Series errors(String name, List<TradeRow> rows, boolean isLabelled) {
    List<LogChart.Point> points =
        rows.stream()
            .map(row -> error(row, isLabelled ? String.valueOf(row.samples()) : "", false))
            .toList();
    return new LogChart.Series(name, points, true);
  }

  private static LogChart.Point error(TradeRow row, String label, boolean isFaint) {
    return point(row, row.relativeMse(), label, isFaint);
  }

  private static LogChart.Point point(
      TradeRow row, Interval squared, String label, boolean isFaint) {
    return new LogChart.Point(
        row.cpuTime().value(),
        100 * Math.sqrt(squared.value()),
        100 * Math.sqrt(Math.max(0, squared.low())),
        100 * Math.sqrt(squared.high()),
        label,
        isFaint);
  }

  /** Returns the chart of all points of a kind; the points of the Pareto front are connected. */
  private LogChart front(String title, Kind kind) {
    List<LogChart.Point> best = new ArrayList<>();
    List<LogChart.Point> others = new ArrayList<>();
    for (TradeRow row : result.rows()) {
      if (row.setting().kind() == kind) {
        boolean isBeaten = result.isDominated(row);
        (isBeaten ? others : best).add(error(row, "", isBeaten));
      }
    }
    best.sort(Comparator.comparingDouble(LogChart.Point::x));
    LogChart.Series front = new LogChart.Series("front", best, true);
    LogChart.Series dominated = new LogChart.Series("dominated", others, false);
    return new LogChart(title, ACROSS, UP, List.of(front, dominated));
  }

  /** Returns the detected biases, a series for each parameter. */
  private List<LogChart.Series> floors() {
    List<TradeRow> biased =
        result.settings(Kind.BIAS).stream()
            .map(result::most)
            .filter(most -> most.bias().isDetected())
            .toList();
    List<LogChart.Series> series = new ArrayList<>();
    for (Knob knob : biased.stream().map(row -> row.setting().knob()).distinct().toList()) {
      List<LogChart.Point> points =
          biased.stream()
              .filter(row -> row.setting().knob() == knob)
              .map(row -> point(row, interval(row.bias()), row.setting().value(), false))
              .toList();
      series.add(new LogChart.Series(SettingType.nameOf(knob), points, false));
    }
    return series;
  }

  private static Interval interval(TradeRow.Bias bias) {
    return new Interval(bias.squared(), bias.low(), bias.high());
  }
}
