package io.github.lumbre.measure;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.math.Elementary;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The page that shows what a study found: one HTML file that needs no other. */
public final class TradePage {
  private static final String STYLE =
      """
      body{font:15px/1.5 system-ui,sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#111}
      table{border-collapse:collapse;margin:1em 0}th,td{padding:.2em .7em;text-align:right;border-bottom:1px solid #ddd}
      th:first-child,td:first-child{text-align:left}tr.dominated{color:#999}figure{display:inline-block;margin:.5em}
      figcaption{font-size:13px;max-width:22em}img{image-rendering:pixelated;width:20em}
      """;

  /** Errors that a reader may want, as relative root mean squared errors. */
  private static final double[] TARGETS = {.5, .2, .1, .05, .02, .01};

  private final String title;
  private final Map<String, String> facts;
  private final TradeResult result;
  private final ImageWriter.Options options;
  private final StringBuilder html = new StringBuilder();

  private TradePage(
      String title, Map<String, String> facts, TradeResult result, ImageWriter.Options options) {
    this.title = title;
    this.facts = facts;
    this.result = result;
    this.options = options;
  }

  /**
   * Returns the page.
   *
   * @param facts of the run, by name: machine, seeds, how to repeat it
   * @param options by which pictures become visible
   * @throws IOException if pictures cannot be written to the directory for temporary files
   */
  public static String of(
      String title, Map<String, String> facts, TradeResult result, ImageWriter.Options options)
      throws IOException {
    TradePage page = new TradePage(title, facts, result, options);
    page.write();
    return page.html.toString();
  }

  private void write() throws IOException {
    html.append("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>")
        .append(LogChart.escaped(title))
        .append("</title><style>\n")
        .append(STYLE)
        .append("</style></head><body>\n");
    element("h1", title);
    Map<String, String> all = new LinkedHashMap<>(facts);
    all.put("reference", reference());
    table(
        List.of("", ""),
        all.entrySet().stream().map(e -> plain(e.getKey(), e.getValue())).toList());
    advice();
    variance();
    bias();
    exact();
    pictures();
    all();
    html.append("</body></html>\n");
  }

  private String reference() {
    NoiseEstimate noise = result.referenceNoise();
    return "%d samples per pixel; its own relative RMSE is about %s, at most %s with 95 %% confidence"
        .formatted(
            result.referenceSamples(),
            percent(noise.relativeRmse()),
            percent(noise.upperRelativeRmse()));
  }

  private void advice() {
    element("h2", "For this error pick these settings");
    element(
        "p",
        "The least processor time at which the relative RMSE against the reference, all seeds"
            + " together, is not above the error. Errors below the reference's own cannot be"
            + " told.");
    List<List<String>> rows = new ArrayList<>();
    for (double target : TARGETS) {
      Optional<TradeRow> best =
          result.rows().stream()
              .filter(row -> row.relativeMse().value() <= target * target)
              .min(Comparator.comparingDouble(row -> row.cpuTime().value()));
      List<String> row = new ArrayList<>(List.of(percent(target)));
      row.addAll(
          best.map(
                  b ->
                      List.of(
                          "-s " + b.samples() + " --" + b.setting().label(),
                          seconds(b.cpuTime()),
                          count(b.rays() + b.shadowRays()),
                          percent(Math.sqrt(b.relativeMse().value()))))
              .orElse(List.of("not reached", "", "", "")));
      rows.add(row);
    }
    table(
        List.of("relative RMSE", "settings", "CPU time", "rays", "measured"),
        rows.stream().map(Row::plain).toList());
  }

  private void variance() {
    element("h2", "Samples: error is noise, and falls with time");
    List<LogChart.Series> series = new ArrayList<>();
    for (String label : labels()) {
      List<TradeRow> rows = of(label);
      if (rows.get(0).setting().isUnbiased()) {
        series.add(new LogChart.Series(label, points(rows)));
        slope(rows).ifPresent(s -> element("p", label + ": relative MSE ~ samples^" + number(s)));
      }
    }
    html.append(new LogChart("CPU seconds", "relative RMSE, %", series).svg());
    element(
        "p",
        "Numbers at the points are samples per pixel; bars are intervals of 95 % over the seeds."
            + " Grey: another point takes less time and has less error.");
  }

  private List<LogChart.Point> points(List<TradeRow> rows) {
    return rows.stream()
        .map(
            row -> {
              Interval error = row.relativeMse();
              return new LogChart.Point(
                  row.cpuTime().value(),
                  100 * Math.sqrt(error.value()),
                  100 * Math.sqrt(Math.max(0, error.low())),
                  100 * Math.sqrt(error.high()),
                  String.valueOf(row.samples()),
                  TradeResult.isDominated(row, rows));
            })
        .toList();
  }

  private static Optional<Double> slope(List<TradeRow> rows) {
    if (rows.size() < 2) {
      return Optional.empty();
    }
    double n = rows.size();
    double sx = 0;
    double sy = 0;
    double sxx = 0;
    double sxy = 0;
    for (TradeRow row : rows) {
      double lx = Elementary.log(row.samples());
      double ly = Elementary.log(row.relativeMse().value());
      sx += lx;
      sy += ly;
      sxx += lx * lx;
      sxy += lx * ly;
    }
    return Optional.of((n * sxy - sx * sy) / (n * sxx - sx * sx));
  }

  private void bias() {
    element("h2", "Depth and mode: error that samples do not take away");
    element(
        "p",
        "The bias of each setting: how far the mean of all seeds' pictures is from the reference,"
            + " noise of both taken off. Against the processor time of the most samples.");
    List<LogChart.Series> series = new ArrayList<>();
    List<Row> rows = new ArrayList<>();
    for (String label : labels()) {
      List<TradeRow> own = of(label);
      TradeRow most = own.get(own.size() - 1);
      TradeRow.Bias bias = most.bias();
      rows.add(
          Row.plain(
              List.of(
                  label,
                  seconds(most.cpuTime()),
                  count(most.rays() + most.shadowRays()),
                  bias.isDetected()
                      ? percent(root(bias.squared()))
                      : "not detected, < " + percent(root(bias.high())),
                  bias.isDetected()
                      ? percent(root(bias.low())) + " to " + percent(root(bias.high()))
                      : "",
                  number(most.signedError().value()))));
      if (bias.isDetected()) {
        series.add(
            new LogChart.Series(
                label,
                List.of(
                    new LogChart.Point(
                        most.cpuTime().value(),
                        100 * root(bias.squared()),
                        100 * root(bias.low()),
                        100 * root(bias.high()),
                        most.setting().value(),
                        false))));
      }
    }
    html.append(new LogChart("CPU seconds", "bias, relative RMS, %", series).svg());
    table(List.of("setting", "CPU time", "rays", "bias", "95 %", "mean signed error"), rows);
  }

  private void exact() {
    element("h2", "Threads and buckets: time alone");
    table(
        List.of("setting", "time ratio", "95 %", "picture"),
        result.exact().stream()
            .map(
                row ->
                    Row.plain(
                        List.of(
                            row.setting(),
                            number(row.timeRatio().value()),
                            number(row.timeRatio().low()) + " to " + number(row.timeRatio().high()),
                            row.isSamePicture() ? "the same bits" : "DIFFERENT")))
            .toList());
  }

  private void pictures() throws IOException {
    element("h2", "Pictures and where they are wrong");
    element(
        "p", "Errors: black 0.1 % and less, purple 1 %, orange 10 %, pale yellow 100 % and more.");
    picture(result.reference(), "reference");
    for (String label : labels()) {
      List<TradeRow> rows = of(label);
      html.append("<div>");
      for (TradeRow row :
          rows.get(0).setting().isUnbiased() ? rows : rows.subList(rows.size() - 1, rows.size())) {
        String name = label + ", " + row.samples() + " samples";
        picture(row.picture(), name + ": " + percent(Math.sqrt(row.errors().get(0).relativeMse())));
        image(
            ErrorMap.of(row.picture(), result.reference()),
            ImageWriter.Options.DEFAULT,
            "error of " + name);
      }
      html.append("</div>\n");
    }
  }

  private void picture(Image image, String caption) throws IOException {
    image(image, options, caption);
  }

  private void image(Image image, ImageWriter.Options how, String caption) throws IOException {
    Path file = Files.createTempFile("lumbre-", ".png");
    try {
      ImageWriter.write(image, file, how);
      String data = Base64.getEncoder().encodeToString(Files.readAllBytes(file));
      html.append("<figure><img alt=\"")
          .append(LogChart.escaped(caption))
          .append("\" src=\"data:image/png;base64,")
          .append(data)
          .append("\"><figcaption>")
          .append(LogChart.escaped(caption))
          .append("</figcaption></figure>\n");
    } finally {
      Files.deleteIfExists(file);
    }
  }

  private void all() {
    element("h2", "All that was measured");
    List<Row> rows = new ArrayList<>();
    for (TradeRow row : result.rows()) {
      Interval error = row.relativeMse();
      rows.add(
          new Row(
              List.of(
                  row.setting().label(),
                  String.valueOf(row.samples()),
                  seconds(row.time()),
                  seconds(row.cpuTime()),
                  count(row.rays()),
                  count(row.shadowRays()),
                  number(error.value()) + " ± " + number(error.high() - error.value()),
                  number(row.signedError().value()),
                  number(row.largestError()),
                  number(row.flip().value()),
                  efficiency(error.value() * row.cpuTime().value())),
              TradeResult.isDominated(row, result.rows())));
    }
    table(
        List.of(
            "setting",
            "samples",
            "time",
            "CPU time",
            "rays",
            "shadow rays",
            "relMSE",
            "signed error",
            "max error",
            "FLIP",
            "1/(relMSE CPU s)"),
        rows);
    element("p", "Grey: another row takes less time and has less error.");
  }

  private Set<String> labels() {
    Set<String> labels = new LinkedHashSet<>();
    result.rows().forEach(row -> labels.add(row.setting().label()));
    return labels;
  }

  private List<TradeRow> of(String label) {
    return result.rows().stream().filter(row -> row.setting().label().equals(label)).toList();
  }

  /** A table's line; faint if another is better in every way. */
  private record Row(List<String> cells, boolean isFaint) {
    static Row plain(List<String> cells) {
      return new Row(cells, false);
    }
  }

  private static Row plain(String... cells) {
    return Row.plain(List.of(cells));
  }

  private void table(List<String> head, List<Row> rows) {
    html.append("<table><tr>");
    head.forEach(cell -> html.append("<th>").append(LogChart.escaped(cell)).append("</th>"));
    html.append("</tr>\n");
    for (Row row : rows) {
      html.append(row.isFaint ? "<tr class=\"dominated\">" : "<tr>");
      row.cells.forEach(cell -> html.append("<td>").append(LogChart.escaped(cell)).append("</td>"));
      html.append("</tr>\n");
    }
    html.append("</table>\n");
  }

  private void element(String name, String text) {
    html.append("<").append(name).append(">").append(LogChart.escaped(text));
    html.append("</").append(name).append(">\n");
  }

  /** Returns the inverse of error times time; nothing where the clock was too coarse for it. */
  private static String efficiency(double product) {
    return product > 0 ? number(1 / product) : "";
  }

  private static double root(double squared) {
    return Math.sqrt(Math.max(0, squared));
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.2g %%", 100 * share);
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.3g", value);
  }

  private static String seconds(Interval time) {
    return String.format(Locale.ROOT, "%.3g s ± %.2g", time.value(), time.high() - time.value());
  }

  private static String count(double value) {
    return value >= 1e6
        ? String.format(Locale.ROOT, "%.3g M", value / 1e6)
        : String.format(Locale.ROOT, "%.0f", value);
  }
}
