package io.github.lumbre.lab.trade;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.image.compare.TestPictures;
import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.trade.TradeRow.Bias;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests which settings a trade study recommends. */
class TradeAdviceTest {
  private static final Image TRUTH = TestPictures.pattern(8, 8);
  private static final Bias NONE = new Bias(0, -1e-5, 2e-5);

  private static TradeSetting setting(Kind kind, String flags) {
    return new TradeSetting(Knob.DEPTH, flags, kind, flags, null, null, null, null);
  }

  private static TradeRow row(
      TradeSetting setting, int samples, double error, double cpuSeconds, Bias bias) {
    PictureError own = new PictureError(error, error * error, 0, error, error, 1, 0);
    Cost cost = new Cost(cpuSeconds, cpuSeconds, 0);
    List<TradeShot> seeds =
        Collections.nCopies(3, new TradeShot(setting, samples, 1, cost, own, TRUTH));
    return new TradeRow(seeds, new TradeWork(2, 1, 5, 0), bias);
  }

  /** Returns the line of the table for an error. */
  private static String advice(String error, TradeRow... rows) {
    Html html = new Html();
    TradeAdvice.addTo(html, new TradeResult(TRUTH, 64, null, List.of(rows), List.of()));
    return html.toString()
        .lines()
        .filter(line -> line.startsWith("<tr><td>" + error))
        .findFirst()
        .orElseThrow();
  }

  private static TradeRow[] rowsOf(TradeRow other) {
    TradeSetting deep = setting(Kind.NOISE, "--depth 1000");
    return new TradeRow[] {
      row(deep, 8, .2, 8, NONE), row(deep, 16, .12, 16, NONE), other,
    };
  }

  @Test
  void cheaperSettingsWithoutDetectedBiasAreRecommended() {
    TradeRow shallow = row(setting(Kind.BIAS, "--depth 5"), 16, .1, 4, NONE);
    assertThat(advice("10 %", rowsOf(shallow)))
        .startsWith("<tr><td>10 %</td><td>-s 16 --depth 5</td><td>about 4.00 s</td>")
        .contains("<td>&lt; 0.45 %</td>");
  }

  @Test
  void settingsWhoseBiasIsDetectedOrMayExceedTheErrorAreNot() {
    for (Bias bias : List.of(new Bias(4e-3, 1e-3, 8e-3), new Bias(4e-3, -1e-3, 2e-2))) {
      TradeRow shallow = row(setting(Kind.BIAS, "--depth 5"), 16, .1, 4, bias);
      assertThat(advice("10 %", rowsOf(shallow)))
          .contains("-s 24 --depth 1000</td><td>extrapolated 23")
          .contains("<td>none</td><td>-s 16 --depth 5");
    }
  }

  /** The other setting would take 92 s if its error continued to decrease. */
  @Test
  void measuredSettingsGoBeforeExtrapolatedOnes() {
    TradeRow split = row(setting(Kind.NOISE, "--split 8 --depth 1000"), 16, .05, 130, NONE);
    assertThat(advice("5.0 %", rowsOf(split)))
        .contains("<td>-s 16 --split 8 --depth 1000</td><td>about 130 s</td>")
        .doesNotContain("extrapolated");
  }
}
