package io.github.lumbre.lab.trade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.lab.trade.TimeToError.Cost;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.xml.sax.InputSource;

/** Tests the tables of a trade study for each scene. */
class SceneTablesTest {
  private static final TradeWork WORK = new TradeWork(4, 2, 30, 1.5);
  private static final TradeRow.Bias NONE = new TradeRow.Bias(0, -1e-4, 1e-4);
  private static final TradeRow.Bias SOME = new TradeRow.Bias(.04, .0361, .0441);

  private static SceneTrade.Row row(
      String knob, String value, boolean unbiased, int samples, double error, TradeRow.Bias bias) {
    Cost cost =
        new Cost(samples, List.of(error, error, error), List.of(.1 * samples, .1 * samples, 1.));
    return new SceneTrade.Row(knob, value, unbiased, cost, WORK, bias);
  }

  private static SceneTrade scene(String name, boolean hasLights) {
    List<SceneTrade.Row> rows = new ArrayList<>();
    rows.add(row("depth", "1000", true, 4, .04, NONE));
    rows.add(row("depth", "1000", true, 16, .01, NONE));
    if (hasLights) {
      rows.add(row("lights", "power", true, 16, .02, NONE));
    }
    rows.add(row("depth", "2", false, 16, .05, SOME));
    rows.add(row("depth", "5", false, 16, .01, NONE));
    Map<String, String> facts = Map.of("command", "lumbre trade " + name + ".json", "load", "0.1");
    return new SceneTrade(name, 100, 50, 3, 1024, .005, facts, rows);
  }

  @Test
  void tablesHaveALineForEachScene() {
    String text =
        new SceneTables(List.of(scene("a", false), scene("b", true)))
            .markdown("lumbre trade table");
    assertThat(text)
        // Reached with 16 samples; a tenth of the error takes ten times as many, after subtraction
        // of the reference's squared error of 2.5e-5.
        .contains("| a | 100x50 | 3 | 1024: 0.50 % | 16: 10 % | -1.00 | 16 (16 to 16) | 96 | ")
        .contains(" | 160 (160 to 160) * | 958 * | ")
        .contains("```sh\nlumbre trade a.json\nlumbre trade b.json\nlumbre trade table\n```")
        .contains("| b |  |  | 0.1 |  |  |")
        .contains("| scene | depth 2 | depth 5 |", "| b | 20 % | < 1.0 % |")
        .contains("| scene | light selection: power |", "| a |  |", "| b | 0.50 (0.50 to 0.50) |")
        .contains("| a | 4.00 | 2.00 | 30.0 | 1.50 |")
        .doesNotContain("NaN", "Infinity");
  }

  /** The reference's squared error of 1.44e-4 is small compared with 1e-2, but not with 1e-3. */
  @Test
  void whatTheReferenceCannotTellIsMarked() {
    List<SceneTrade.Row> rows =
        List.of(
            row("depth", "1000", true, 16, .01 + 1.44e-4, NONE),
            row("depth", "1000", true, 256, .0005 + 1.44e-4, NONE));
    SceneTrade scene = new SceneTrade("a", 100, 50, 3, 1024, .012, Map.of(), rows);
    assertThat(scene.toError(.001).isExtrapolated()).isFalse();
    assertThat(scene.toError(.01).samples().value()).isCloseTo(16, within(1e-9));
    assertThat(new SceneTables(List.of(scene)).markdown(""))
        .contains(" | 16 (16 to 16) | 96 | ")
        .containsPattern("130 \\(130 to 130\\) \\* \\| 809 \\* ");
  }

  /** A setting with fewer samples than the baseline is compared at its own number of samples. */
  @Test
  void gainsAreAtTheSameSamples() {
    List<SceneTrade.Row> rows =
        List.of(
            row("depth", "1000", true, 16, .01, NONE),
            row("depth", "1000", true, 256, .0005, NONE),
            row("lights", "power", true, 16, .02, NONE));
    SceneTrade scene = new SceneTrade("a", 100, 50, 3, 1024, 0, Map.of(), rows);
    assertThat(scene.gainByRays(scene.of("light selection: power")).value())
        .isCloseTo(.5, within(1e-9));
  }

  @Test
  void chartsAreDrawingsOfTheirOwn() throws Exception {
    SceneTables tables = new SceneTables(List.of(scene("a", false), scene("b", true)));
    for (String chart : List.of(tables.noiseChart(), tables.depthChart())) {
      assertThat(chart)
          .contains(">a</text>", ">b</text>", "prefers-color-scheme")
          .doesNotContain("NaN");
      DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(new InputSource(new StringReader(chart)));
    }
  }
}
