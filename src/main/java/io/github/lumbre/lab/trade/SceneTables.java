package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.metrics.Interval;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;

/** Formats studies of several scenes as tables in Markdown and standalone charts. */
public final class SceneTables {
  private static final double[] TARGETS = {1e-2, 1e-3};

  /** The facts about a run that influence its times. */
  private static final List<String> TOLD = List.of("machine", "threads", "load", "version", "took");

  private final List<SceneTrade> scenes;

  /**
   * @param scenes at least one, in the order of the tables
   */
  public SceneTables(List<SceneTrade> scenes) {
    this.scenes = List.copyOf(scenes);
  }

  /**
   * Returns all tables with explanations, and the commands that produce them.
   *
   * @param command command line that makes the tables from the studies
   */
  public String markdown(String command) {
    return String.join("\n", commands(command), noise(), floors(), gains(), work(), runs());
  }

  private String commands(String command) {
    List<String> lines =
        new ArrayList<>(List.of("# Speed for accuracy, scene by scene\n", "```sh"));
    scenes.stream()
        .map(scene -> scene.facts().get("command"))
        .filter(Objects::nonNull)
        .forEach(lines::add);
    lines.addAll(List.of(command, "```\n"));
    lines.add(
        "Each study is a separate file, so a single study can be repeated and the tables made"
            + " again. [trade.md](trade.md#the-projects-scenes) explains the choice of scenes.\n");
    return String.join("\n", lines);
  }

  private String runs() {
    List<String> lines = new ArrayList<>(List.of("## Runs\n"));
    lines.add("| scene | " + String.join(" | ", TOLD) + " |");
    lines.add("|---".repeat(TOLD.size() + 1) + "|");
    for (SceneTrade scene : scenes) {
      List<String> cells = new ArrayList<>(List.of(scene.scene()));
      TOLD.forEach(fact -> cells.add(scene.facts().getOrDefault(fact, "")));
      lines.add(line(cells));
    }
    return String.join("\n", lines) + "\n";
  }

  /** Returns a chart of noise against rays, a measure of work that is the same on every machine. */
  public String noiseChart() {
    List<LogChart.Series> series = new ArrayList<>();
    for (SceneTrade scene : scenes) {
      List<LogChart.Point> points = new ArrayList<>();
      double rays = scene.usual().get(0).rays();
      for (TimeToError.Cost cost : scene.usualCosts()) {
        Interval error = Interval.ofGeometricMean(cost.relativeMse());
        points.add(
            new LogChart.Point(
                cost.samples() * rays,
                100 * Math.sqrt(error.value()),
                100 * Math.sqrt(error.low()),
                100 * Math.sqrt(error.high()),
                "",
                false));
      }
      series.add(new LogChart.Series(scene.scene(), points, true));
    }
    return new LogChart("Noise against work", "rays per pixel", "relative RMSE, %", series).file();
  }

  /** Returns a chart of the bias of each depth, where it was detected. */
  public String depthChart() {
    List<LogChart.Series> series = new ArrayList<>();
    for (SceneTrade scene : scenes) {
      List<LogChart.Point> points = new ArrayList<>();
      for (SceneTrade.Row row : scene.rows()) {
        boolean isMost = row == SceneTrade.most(scene.of(row.label()));
        if (row.knob().equals("depth") && !row.isUnbiased() && isMost && row.bias().isDetected()) {
          points.add(
              new LogChart.Point(
                  Double.parseDouble(row.value()),
                  100 * Math.sqrt(row.bias().squared()),
                  100 * Math.sqrt(row.bias().low()),
                  100 * Math.sqrt(row.bias().high()),
                  "",
                  false));
        }
      }
      series.add(new LogChart.Series(scene.scene(), points, true));
    }
    return new LogChart("Bias against depth", "depth", "bias, relative RMS, %", series).file();
  }

  private String noise() {
    List<String> lines = new ArrayList<>();
    lines.add("## Noise, and the cost of reducing it\n");
    lines.add(
        "| scene | pixels | seeds | reference | noise | convergence exponent | samples to 1e-2"
            + " | rays | CPU s | samples to 1e-3 | rays | CPU s |");
    lines.add("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for (SceneTrade scene : scenes) {
      List<TimeToError.Cost> costs = scene.usualCosts();
      TimeToError.Cost most = costs.get(costs.size() - 1);
      double rays = scene.usual().get(0).rays();
      List<String> cells =
          new ArrayList<>(
              List.of(
                  scene.scene(),
                  scene.width() + "x" + scene.height(),
                  String.valueOf(scene.seeds()),
                  scene.referenceSamples() + ": " + Markdown.percent(scene.referenceRmse()),
                  most.samples()
                      + ": "
                      + TradeText.rootPercent(Interval.ofMean(most.relativeMse()).value()),
                  TradeText.slope(costs)));
      for (double target : TARGETS) {
        TimeToError cost = scene.toError(target);
        String mark = cost.isExtrapolated() || !scene.canTell(target) ? " *" : "";
        cells.add(round(cost.samples(), 1) + mark);
        cells.add(String.format(Locale.ROOT, "%.0f", cost.samples().value() * rays) + mark);
        cells.add(round(cost.cpuSeconds(), 1e6 / scene.pixels()) + mark);
      }
      lines.add(line(cells));
    }
    lines.add(
        "\n"
            + "Noise: relative RMSE at the largest number of samples, without the reference's own"
            + " estimated noise (next to its samples). 1e-2 and 1e-3 are relative mean squared"
            + " errors, 10 % and 3.2 % as relative RMSE. Rays are per pixel, CPU seconds per"
            + " million pixels, interpolated between measured numbers of samples, each twice the"
            + " previous. Convergence exponent: the squared error is proportional to the samples to"
            + " this power; -1 for independent samples. An asterisk marks less reliable values."
            + " Either a seed does not reach the error with the measured samples; beyond them the"
            + " squared error is assumed inversely proportional to the samples, which is slower"
            + " than it usually falls. Or the squared error of the reference exceeds 1/8 of the"
            + " target.\n");
    return String.join("\n", lines);
  }

  private String floors() {
    Set<String> labels = labels(false);
    List<String> lines = new ArrayList<>();
    lines.add("## Bias of biased settings\n");
    lines.add("| scene | " + String.join(" | ", labels) + " |");
    lines.add("|---" + "|--:".repeat(labels.size()) + "|");
    for (SceneTrade scene : scenes) {
      List<String> cells = new ArrayList<>(List.of(scene.scene()));
      for (String label : labels) {
        List<SceneTrade.Row> own = scene.of(label);
        cells.add(own.isEmpty() ? "" : bias(SceneTrade.most(own).bias()));
      }
      lines.add(line(cells));
    }
    lines.add(
        "\n"
            + "Relative root mean squared bias. \"<\": not detected; upper bound with 95 %"
            + " confidence.\n");
    return String.join("\n", lines);
  }

  private String gains() {
    Set<String> labels = labels(true);
    List<String> lines = new ArrayList<>();
    lines.add("## Efficiency of unbiased settings\n");
    lines.add("| scene | " + String.join(" | ", labels) + " |");
    lines.add("|---" + "|--:".repeat(labels.size()) + "|");
    for (SceneTrade scene : scenes) {
      List<String> cells = new ArrayList<>(List.of(scene.scene()));
      for (String label : labels) {
        List<SceneTrade.Row> own = scene.of(label);
        cells.add(own.isEmpty() ? "" : TradeText.ratio(scene.gainByRays(own)));
      }
      lines.add(line(cells));
    }
    lines.add(
        "\n"
            + "Efficiency relative to the baseline: 1 / (squared error × rays), with its 95 %"
            + " interval; below 1 is worse.\n");
    return String.join("\n", lines);
  }

  private String work() {
    List<String> lines = new ArrayList<>();
    lines.add("## Work per sample\n");
    lines.add("| scene | rays | shadow rays | nodes | look-ups |");
    lines.add("|---|--:|--:|--:|--:|");
    for (SceneTrade scene : scenes) {
      TradeWork work = SceneTrade.most(scene.usual()).work();
      lines.add(
          line(
              List.of(
                  scene.scene(),
                  TradeText.number(work.rays()),
                  TradeText.number(work.shadowRays()),
                  TradeText.number(work.nodes()),
                  TradeText.number(work.lookUps()))));
    }
    return String.join("\n", lines) + "\n";
  }

  private Set<String> labels(boolean unbiased) {
    return scenes.stream()
        .flatMap(scene -> scene.rows().stream().skip(scene.usual().size()))
        .filter(row -> row.isUnbiased() == unbiased)
        .map(SceneTrade.Row::label)
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  private static String bias(TradeRow.Bias bias) {
    return bias.isDetected()
        ? TradeText.rootPercent(bias.squared())
        : "< " + TradeText.rootPercent(bias.high());
  }

  private static String round(Interval interval, double factor) {
    return "%s (%s to %s)"
        .formatted(
            twoDigits(factor * interval.value()),
            twoDigits(factor * interval.low()),
            twoDigits(factor * interval.high()));
  }

  private static String twoDigits(double value) {
    return new BigDecimal(value).round(new MathContext(2)).stripTrailingZeros().toPlainString();
  }

  private static String line(List<String> cells) {
    return "| " + String.join(" | ", cells) + " |";
  }
}
