package io.github.lumbre.lab.trade;

import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.trade.Html.Row;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import io.github.lumbre.scene.SettingType;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * The page of a study's results: a single self-contained HTML file. {@link TradeAdvice}, {@link
 * TradeCharts} and {@link TradePictures} produce its sections.
 */
public final class TradePage {
  /** Shown instead of a time ratio if the times are too short. */
  private static final String TOO_SHORT = "too short to measure";

  private final Map<String, String> facts;
  private final TradeResult result;
  private final Html html = new Html();

  private TradePage(Map<String, String> facts, TradeResult result) {
    this.facts = facts;
    this.result = result;
  }

  /**
   * Returns the page.
   *
   * @param scene name of the scene
   * @param facts facts about the run, by name: machine, seeds, command line
   * @param options options for writing the pictures
   * @throws IOException if pictures cannot be written to the directory for temporary files
   */
  public static String of(
      String scene, Map<String, String> facts, TradeResult result, ImageWriter.Options options)
      throws IOException {
    TradePage page = new TradePage(facts, result);
    page.write(scene, new TradePictures(result, options));
    return page.html.toString();
  }

  private void write(String scene, TradePictures pictures) throws IOException {
    String title = "Speed for accuracy: " + scene;
    html.raw("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">")
        .raw("<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">")
        // An empty icon keeps browsers from requesting one.
        .raw("<link rel=\"icon\" href=\"data:,\">")
        .element("title", title)
        .raw("<style>\n" + TradeStyle.SHEET + "</style></head><body>")
        .element("h1", title)
        .raw("<p class=\"lead\">" + Html.escaped(lead()) + "</p>");
    TradeAdvice.addTo(html, result);
    noise();
    bias();
    denoised();
    exact();
    pictures.addTo(html);
    everything();
    method();
    html.raw("</body></html>");
  }

  private String lead() {
    return ("%s pixels, %d seeds of each setting, compared with a reference of %s samples per"
            + " pixel. The relative RMSE of the reference itself is about %s.")
        .formatted(
            facts.get("size"),
            result.seeds(),
            result.referenceSamples(),
            Markdown.percent(result.referenceNoise().relativeRmse()));
  }

  private void noise() {
    html.element("h2", "Unbiased settings: noise")
        .element(
            "p",
            "These settings all converge to the same picture. Their error is only noise and falls"
                + " with time; lower lines are better. Numbers at the points are samples per pixel;"
                + " bars are 95 % intervals over the seeds.");
    charts(TradeCharts.noise(result));
    List<Row> rows = new ArrayList<>();
    for (TradeSetting setting : result.settings(Kind.NOISE)) {
      TradeRow most = result.most(setting);
      TradeWork work = most.work();
      boolean isUsual = setting == result.usual().get(0).setting();
      rows.add(
          new Row(
              List.of(
                  isUsual ? "baseline" : setting.label(),
                  isUsual ? "1" : TradeText.ratio(result.gainByRays(setting)),
                  isUsual ? "1" : result.gain(setting).map(TradeText::ratio).orElse(TOO_SHORT),
                  TradeText.rootPercent(most.relativeMse().value()),
                  TradeText.seconds(most.cpuTime()),
                  TradeText.number(work.rays() + work.shadowRays()),
                  TradeText.number(work.nodes()),
                  TradeText.number(work.lookUps()),
                  TradeText.slope(result.of(setting).stream().map(TradeRow::cost).toList())),
              isUsual ? "best" : ""));
    }
    html.table(
            List.of(
                "setting",
                "gain for the same rays",
                "gain for the same time",
                "error",
                "CPU time",
                "rays",
                "nodes",
                "look-ups",
                "convergence exponent"),
            rows)
        .note(
            "Gain: efficiency relative to the baseline, 1 / (squared error × rays) or 1 / (squared"
                + " error × CPU time), at the largest number of samples; below 1 is worse. Rays,"
                + " visited nodes of the bounding volume hierarchy and texture look-ups are per"
                + " sample, and the same on every machine. Convergence exponent: the squared error"
                + " is proportional to the samples to this power; -1 for independent samples, lower"
                + " is better. Baseline: Sobol points, lights selected by their expected"
                + " contribution, light and BSDF sampling combined by multiple importance sampling"
                + " (MIS) with the power heuristic, Russian roulette from vertex 1. Settings named"
                + " \"only\" use a single sampling technique.");
  }

  private void bias() {
    html.element("h2", "Biased settings")
        .element(
            "p",
            "These settings converge to a different picture, so more samples do not reduce their"
                + " error below their bias. Do not rank them with the unbiased settings: bias may"
                + " matter more or less than noise.");
    charts(TradeCharts.bias(result));
    List<Row> rows = new ArrayList<>();
    for (TradeSetting setting : result.settings(Kind.BIAS)) {
      TradeRow most = result.most(setting);
      TradeRow.Bias bias = most.bias();
      TradeWork work = most.work();
      rows.add(
          Row.of(
              setting.label(),
              bias.isDetected()
                  ? TradeText.rootPercent(bias.squared())
                  : "not detected, < " + TradeText.rootPercent(bias.high()),
              bias.isDetected()
                  ? TradeText.rootPercent(bias.low()) + " to " + TradeText.rootPercent(bias.high())
                  : "",
              TradeText.number(most.signedError().value()),
              TradeText.seconds(most.cpuTime()),
              TradeText.number(work.rays() + work.shadowRays()),
              TradeText.number(work.nodes()),
              TradeText.number(work.lookUps())));
    }
    html.table(
            List.of(
                "setting",
                "bias",
                "95 % interval",
                "mean signed error",
                "CPU time",
                "rays",
                "nodes",
                "look-ups"),
            rows)
        .note(
            "Bias: relative RMS difference between the mean of all seeds' pictures and the"
                + " reference, with the noise of both subtracted. More samples do not reduce it.");
  }

  private void denoised() {
    List<TradeSetting> settings = result.settings(Kind.DENOISED);
    if (settings.isEmpty()) {
      return;
    }
    html.element("h2", "Denoised pictures")
        .element(
            "p",
            "A denoiser removes noise and adds bias. No bound on the error of a render holds for"
                + " its denoised picture.");
    charts(TradeCharts.denoised(result));
    List<TimeToError.Cost> usual = result.usual().stream().map(TradeRow::cost).toList();
    List<Row> rows = new ArrayList<>();
    for (TradeSetting setting : settings) {
      for (TradeRow row : result.of(setting)) {
        TradeRow noisy = result.usual(row.samples());
        TimeToError same = TimeToError.of(usual, row.relativeMse().value());
        rows.add(
            Row.of(
                String.valueOf(row.samples()),
                TradeText.rootPercent(noisy.relativeMse().value()),
                TradeText.rootPercent(row.relativeMse().value()),
                (same.isExtrapolated() ? "about " : "")
                    + TradeText.number(same.samples().value() / row.samples()),
                TradeText.number(noisy.flip().value()),
                TradeText.number(row.flip().value()),
                (row.bias().isDetected() ? "" : "not detected, < ")
                    + TradeText.rootPercent(
                        row.bias().isDetected() ? row.bias().squared() : row.bias().high()),
                TradeText.number(row.signedError().value()),
                TradeText.seconds(noisy.cpuTime()),
                TradeText.seconds(row.cpuTime())));
      }
    }
    html.table(
            List.of(
                "samples",
                "noisy error",
                "denoised error",
                "as many times the samples",
                "noisy FLIP",
                "denoised FLIP",
                "bias",
                "mean signed error",
                "noisy CPU time",
                "denoised CPU time"),
            rows)
        .note(
            "As many times the samples: how many times the samples the baseline needs for the error"
                + " of the denoised picture; \"about\": beyond the measured samples, where the"
                + " squared error is assumed inversely proportional to the samples. Bias: relative"
                + " RMS difference between the mean of all seeds' denoised pictures and the"
                + " reference, with the noise of both subtracted. The CPU time includes rendering"
                + " the guides and denoising.");
  }

  private void charts(List<LogChart> charts) {
    html.raw("<div class=\"charts\">");
    charts.forEach(chart -> html.raw(chart.svg()));
    html.raw("</div>");
  }

  private void exact() {
    html.element("h2", "Settings that change only the time")
        .table(
            List.of("setting", "CPU time ratio (95 %)", "time ratio (95 %)", "picture"),
            result.exact().stream()
                .map(
                    row ->
                        new Row(
                            List.of(
                                row.setting(),
                                row.cpuRatio().map(TradeText::ratio).orElse(TOO_SHORT),
                                row.timeRatio().map(TradeText::ratio).orElse(TOO_SHORT),
                                row.isSamePicture() ? "identical" : "DIFFERENT"),
                            row.isSamePicture() ? "" : "bad"))
                .toList())
        .note(
            "Five alternating pairs each. The first row compares a setting with itself and shows"
                + " the effect of chance.");
  }

  private void everything() {
    html.element("h2", "All measurements");
    List<Row> rows = new ArrayList<>();
    for (TradeRow row : result.rows()) {
      Interval error = row.relativeMse();
      rows.add(
          new Row(
              List.of(
                  row.setting().label(),
                  SettingType.nameOf(row.setting().kind()),
                  String.valueOf(row.samples()),
                  TradeText.seconds(row.time()),
                  TradeText.seconds(row.cpuTime()),
                  TradeText.count(row.allRays()),
                  TradeText.number(error.value())
                      + " ± "
                      + TradeText.number(error.high() - error.value()),
                  TradeText.number(row.signedError().value()),
                  TradeText.number(row.largestError()),
                  TradeText.number(row.flip().value())),
              result.isDominated(row) ? "dominated" : ""));
    }
    html.table(
            List.of(
                "setting",
                "kind",
                "samples",
                "time",
                "CPU time",
                "rays",
                "relMSE",
                "signed error",
                "max error",
                "FLIP"),
            rows)
        .note("Gray: another row of the same kind takes less time and has less error.");
  }

  private void method() {
    html.element("h2", "How this was measured").raw("<table class=\"facts\">");
    facts.forEach(
        (name, value) ->
            html.raw(
                "<tr><td>"
                    + Html.escaped(name)
                    + "</td><td>"
                    + Html.escaped(value)
                    + "</td></tr>"));
    html.raw("</table>")
        .note(
            "Errors are relative: the root of the mean over pixels and channels of (x - r)² / (r² +"
                + " 0.01), where r is the reference. Times depend on this machine and its load;"
                + " rays, nodes and look-ups are the same everywhere.");
  }
}
