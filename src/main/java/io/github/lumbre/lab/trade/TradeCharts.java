package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** The charts of a study: the Pareto front of each kind of setting, and each setting separately. */
final class TradeCharts {
  private static final String ACROSS = "CPU seconds";
  private static final String UP = "relative RMSE, %";

  private TradeCharts() {}

  /** Returns charts of the unbiased settings. */
  static List<LogChart> noise(TradeResult result) {
    List<LogChart> charts = new ArrayList<>();
    charts.add(front("Unbiased settings with Pareto front", Kind.NOISE, result));
    TradeSetting usual = result.usual().get(0).setting();
    for (String knob : knobs(result, Kind.NOISE)) {
      List<LogChart.Series> series = new ArrayList<>();
      series.add(errors("baseline", result.usual(), true));
      for (TradeSetting setting : result.settings(Kind.NOISE)) {
        if (setting.knob().equals(knob) && setting != usual) {
          series.add(errors(setting.value(), result.of(setting), false));
        }
      }
      if (series.size() > 1) {
        charts.add(new LogChart(title(knob), ACROSS, UP, series));
      }
    }
    return charts;
  }

  /** Returns charts of the biased settings. */
  static List<LogChart> bias(TradeResult result) {
    List<LogChart> charts = new ArrayList<>();
    charts.add(front("Biased settings with Pareto front", Kind.BIAS, result));
    for (String knob : knobs(result, Kind.BIAS)) {
      List<LogChart.Series> series = new ArrayList<>();
      for (TradeSetting setting : result.settings(Kind.BIAS)) {
        if (setting.knob().equals(knob)) {
          series.add(errors(setting.value(), result.of(setting), false));
        }
      }
      charts.add(new LogChart(title(knob), ACROSS, UP, series));
    }
    List<LogChart.Series> floors = floors(result);
    if (!floors.isEmpty()) {
      charts.add(new LogChart("Bias, not reduced by samples", ACROSS, "bias, %", floors));
    }
    return charts;
  }

  /** Returns the chart of denoised pictures beside the baseline. */
  static List<LogChart> denoised(TradeResult result) {
    List<LogChart.Series> series = new ArrayList<>();
    series.add(errors("noisy", result.usual(), true));
    for (TradeSetting setting : result.settings(Kind.DENOISED)) {
      series.add(errors(setting.label(), result.of(setting), false));
    }
    return List.of(new LogChart("Denoising", ACROSS, UP, series));
  }

  private static Set<String> knobs(TradeResult result, Kind kind) {
    Set<String> knobs = new LinkedHashSet<>();
    result.settings(kind).forEach(setting -> knobs.add(setting.knob()));
    return knobs;
  }

  private static String title(String knob) {
    return switch (knob) {
      case "sampler" -> "Sampler: Sobol points or independent";
      case "lights" -> "Light selection";
      case "strategy" -> "Sampling technique: MIS or a single one";
      case "roulette" -> "Russian roulette: first vertex";
      case "split" -> "Path splitting: number of branches";
      case "depth" -> "Depth: scattering vertices of a path";
      case "mode" -> "Classic ray tracing";
      case "filter" -> "Other texture filters than the scene's";
      case "clamp" -> "Clamping";
      case "adaptive" -> "Adaptive sampling";
      default -> knob;
    };
  }

  private static LogChart.Series errors(String name, List<TradeRow> rows, boolean isLabelled) {
    List<LogChart.Point> points =
        rows.stream()
            .map(row -> point(row, isLabelled ? String.valueOf(row.samples()) : "", false))
            .toList();
    return new LogChart.Series(name, points, true);
  }

  private static LogChart.Point point(TradeRow row, String label, boolean isFaint) {
    Interval error = row.relativeMse();
    return new LogChart.Point(
        row.cpuTime().value(),
        100 * Math.sqrt(error.value()),
        100 * Math.sqrt(Math.max(0, error.low())),
        100 * Math.sqrt(error.high()),
        label,
        isFaint);
  }

  /** Returns the chart of all points of a kind; the points of the Pareto front are connected. */
  private static LogChart front(String title, Kind kind, TradeResult result) {
    List<LogChart.Point> best = new ArrayList<>();
    List<LogChart.Point> others = new ArrayList<>();
    for (TradeRow row : result.rows()) {
      if (row.setting().kind() == kind) {
        boolean isBeaten = result.isDominated(row);
        (isBeaten ? others : best).add(point(row, "", isBeaten));
      }
    }
    best.sort((a, b) -> Double.compare(a.x(), b.x()));
    return new LogChart(
        title,
        ACROSS,
        UP,
        List.of(
            new LogChart.Series("front", best, true),
            new LogChart.Series("dominated", others, false)));
  }

  private static List<LogChart.Series> floors(TradeResult result) {
    List<LogChart.Series> series = new ArrayList<>();
    for (String knob : knobs(result, Kind.BIAS)) {
      List<LogChart.Point> points = new ArrayList<>();
      for (TradeSetting setting : result.settings(Kind.BIAS)) {
        TradeRow most = result.most(setting);
        TradeRow.Bias bias = most.bias();
        if (setting.knob().equals(knob) && bias.isDetected()) {
          points.add(
              new LogChart.Point(
                  most.cpuTime().value(),
                  100 * Math.sqrt(bias.squared()),
                  100 * Math.sqrt(bias.low()),
                  100 * Math.sqrt(bias.high()),
                  setting.value(),
                  false));
        }
      }
      if (!points.isEmpty()) {
        series.add(new LogChart.Series(knob, points, false));
      }
    }
    return series;
  }
}
