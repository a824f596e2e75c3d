package io.github.lumbre.lab.trade;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.lab.Table;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import io.github.lumbre.scene.SettingType;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/** The page of a study's results: a single self-contained HTML file of tables. */
public final class TradePage {
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
   */
  public static String of(String scene, Map<String, String> facts, TradeResult result) {
    TradePage page = new TradePage(facts, result);
    page.write(scene);
    return page.html.toString();
  }

  private void write(String scene) {
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
    if (!result.settings(Kind.DENOISED).isEmpty()) {
      denoised();
    }
    exact();
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
            Numbers.percent(result.referenceNoise().relativeRmse()));
  }

  private static String ratio(Optional<Interval> ratio) {
    return ratio.map(interval -> interval.text(2)).orElse("too short to measure");
  }

  private static Function<TradeRow, String> number(ToDoubleFunction<TradeRow> value) {
    return row -> TradeText.number(value.applyAsDouble(row));
  }

  /** Returns a table with the cost of the settings' largest numbers of samples. */
  private static Table<TradeRow> withWork(Table<TradeRow> table) {
    return table
        .number("CPU time", row -> TradeText.seconds(row.cpuTime()))
        .number("rays", number(row -> row.work().allRays()))
        .number("nodes", number(row -> row.work().nodes()))
        .number("look-ups", number(row -> row.work().lookUps()));
  }

  /** Adds a table with the largest numbers of samples of all settings of a kind. */
  private void most(Kind kind, Table<TradeRow> table) {
    List<TradeRow> rows = result.settings(kind).stream().map(result::most).toList();
    html.table("", table, rows, row -> isUsual(row) ? "best" : "");
  }

  private boolean isUsual(TradeRow row) {
    return row.setting() == result.usual().get(0).setting();
  }

  private String slope(TradeRow row) {
    return TradeText.slope(result.of(row.setting()).stream().map(TradeRow::cost).toList());
  }

  private void noise() {
    html.element("h2", "Unbiased settings: noise")
        .element(
            "p",
            "These settings all converge to the same picture. Their error is only noise and falls"
                + " with time.");
    most(
        Kind.NOISE,
        withWork(
                Table.<TradeRow>empty()
                    .text("setting", row -> isUsual(row) ? "baseline" : row.setting().label())
                    .number(
                        "gain for the same rays",
                        row -> isUsual(row) ? "1" : result.gainByRays(row).text(2))
                    .number(
                        "gain for the same time",
                        row -> isUsual(row) ? "1" : ratio(result.gain(row)))
                    .number("error", row -> TradeText.rootPercent(row.relativeMse().value())))
            .number("convergence exponent", this::slope));
    html.note(
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
    most(
        Kind.BIAS,
        withWork(
            Table.<TradeRow>empty()
                .text("setting", row -> row.setting().label())
                .number("bias", row -> TradeText.bias(row.bias(), "not detected, "))
                .number("95 % interval", row -> row.bias().isDetected() ? range(row.bias()) : "")
                .number("mean signed error", number(row -> row.signedError().value()))));
    html.note(
        "Bias: relative RMS difference between the mean of all seeds' pictures and the"
            + " reference, with the noise of both subtracted. More samples do not reduce it.");
  }

  private static String range(TradeRow.Bias bias) {
    return TradeText.rootPercent(bias.low()) + " to " + TradeText.rootPercent(bias.high());
  }

  private TradeRow noisy(TradeRow row) {
    return result.usual(row.samples());
  }

  /** Returns how many times the samples the baseline needs for the error of a denoised picture. */
  private String factor(TradeRow row) {
    List<TimeToError.Cost> usual = result.usual().stream().map(TradeRow::cost).toList();
    TimeToError same = TimeToError.of(usual, row.relativeMse().value());
    return (same.isExtrapolated() ? "about " : "")
        + TradeText.number(same.samples().value() / row.samples());
  }

  private void denoised() {
    html.element("h2", "Denoised pictures")
        .element(
            "p",
            "A denoiser removes noise and adds bias. No bound on the error of a render holds for"
                + " its denoised picture.");
    List<TradeRow> rows =
        result.rows().stream().filter(row -> row.setting().kind() == Kind.DENOISED).toList();
    Table<TradeRow> table =
        Table.<TradeRow>empty()
            .number("samples", TradeRow::samples)
            .number("noisy error", row -> TradeText.rootPercent(noisy(row).relativeMse().value()))
            .number("denoised error", row -> TradeText.rootPercent(row.relativeMse().value()))
            .number("as many times the samples", this::factor)
            .number("noisy FLIP", number(row -> noisy(row).flip().value()))
            .number("denoised FLIP", number(row -> row.flip().value()))
            .number("bias", row -> TradeText.bias(row.bias(), "not detected, "))
            .number("mean signed error", number(row -> row.signedError().value()))
            .number("noisy CPU time", row -> TradeText.seconds(noisy(row).cpuTime()))
            .number("denoised CPU time", row -> TradeText.seconds(row.cpuTime()));
    html.table("", table, rows, row -> "")
        .note(
            "As many times the samples: how many times the samples the baseline needs for the error"
                + " of the denoised picture; \"about\": beyond the measured samples, where the"
                + " squared error is assumed inversely proportional to the samples. Bias: relative"
                + " RMS difference between the mean of all seeds' denoised pictures and the"
                + " reference, with the noise of both subtracted. The CPU time includes rendering"
                + " the guides and denoising.");
  }

  private void exact() {
    Table<ExactRow> table =
        Table.<ExactRow>empty()
            .text("setting", ExactRow::setting)
            .number("CPU time ratio (95 %)", row -> ratio(row.cpuRatio()))
            .number("time ratio (95 %)", row -> ratio(row.timeRatio()))
            .text("picture", row -> row.isSamePicture() ? "identical" : "DIFFERENT");
    html.element("h2", "Settings that change only the time")
        .table("", table, result.exact(), row -> row.isSamePicture() ? "" : "bad")
        .note(
            "Five alternating pairs each. The first row compares a setting with itself and shows"
                + " the effect of chance.");
  }

  private void everything() {
    Table<TradeRow> table =
        Table.<TradeRow>empty()
            .text("setting", row -> row.setting().label())
            .text("kind", row -> SettingType.nameOf(row.setting().kind()))
            .number("samples", TradeRow::samples)
            .number("time", row -> TradeText.seconds(row.time()))
            .number("CPU time", row -> TradeText.seconds(row.cpuTime()))
            .number("rays", row -> Numbers.large(row.allRays()))
            .number("relMSE", row -> error(row.relativeMse()))
            .number("signed error", number(row -> row.signedError().value()))
            .number("max error", number(TradeRow::largestError))
            .number("FLIP", number(row -> row.flip().value()));
    html.element("h2", "All measurements with their Pareto front")
        .table("", table, result.rows(), row -> result.isDominated(row) ? "dominated" : "")
        .note(
            "The rows that are not gray are the Pareto front of their kind: a gray row takes more"
                + " time and has more error than another row of the same kind.");
  }

  private static String error(Interval error) {
    double half = error.high() - error.value();
    return TradeText.number(error.value()) + " ± " + TradeText.number(half);
  }

  private void method() {
    html.element("h2", "How this was measured").raw("<table class=\"facts\">");
    facts.forEach(
        (name, value) -> html.raw("<tr>").element("td", name).element("td", value).raw("</tr>"));
    html.raw("</table>")
        .note(
            "Errors are relative: the root of the mean over pixels and channels of (x - r)² / (r² +"
                + " 0.01), where r is the reference. Times depend on this machine and its load;"
                + " rays, nodes and look-ups are the same everywhere.");
  }

  /** The style sheet of a study's page, for light and dark mode, wide and narrow screens. */
  private static final class TradeStyle {
    static final String SHEET =
"""
:root{color-scheme:light dark;--paper:#fff;--ink:#1c2430;--quiet:#5a6270;
--line:#dde2e8;--bad:#b3261e;--faint:#9aa3ad}
@media(prefers-color-scheme:dark){:root{--paper:#12161c;--ink:#e6eaef;
--quiet:#a3adb9;--line:#303843;--bad:#ff8f73;--faint:#6b7582}}
*{box-sizing:border-box}
body{font:16px/1.55 system-ui,sans-serif;max-width:76rem;margin:0 auto;padding:1.5rem 1rem 4rem;
background:var(--paper);color:var(--ink)}
h1{font-size:1.9rem;line-height:1.2;margin:.5rem 0}
h2{font-size:1.3rem;margin:2.8rem 0 .4rem;border-top:1px solid var(--line);padding-top:1.4rem}
p{max-width:48rem;margin:.4rem 0 .8rem}.lead{font-size:1.08rem;color:var(--quiet)}
.note{font-size:.88rem;color:var(--quiet)}
.scroll{overflow-x:auto;margin:.8rem 0 1.2rem}
.scroll::-webkit-scrollbar{height:.6rem}
.scroll::-webkit-scrollbar-thumb{background:var(--faint);border-radius:.3rem}
.hint{display:none}
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .8rem;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th{color:var(--quiet);font-weight:600}th.group{text-align:center}
th:first-child,td:first-child{text-align:left;padding-left:0}
tr.dominated td{color:var(--faint)}tr.best td{font-weight:650}tr.bad td{color:var(--bad)}
table.facts td{text-align:left;white-space:normal;overflow-wrap:anywhere}
table.facts td:first-child{overflow-wrap:normal}
table.facts td:first-child{color:var(--quiet)}
@media(max-width:40rem){th,td{padding:.3rem .5rem}table{font-size:.82rem}th.group{text-align:left}
.scroll :is(th,td):first-child{position:sticky;left:0;background:var(--paper);min-width:7rem;
white-space:normal}
.hint{display:block;font-size:.82rem;color:var(--quiet);margin:.8rem 0 -.5rem}}
""";

    private TradeStyle() {}
  }
}
