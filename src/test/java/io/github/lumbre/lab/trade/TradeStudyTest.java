package io.github.lumbre.lab.trade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.image.compare.TestPictures;
import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.metrics.Interval;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests the bias and gain estimates of a trade study. */
class TradeStudyTest {
  private static final Image TRUTH = TestPictures.pattern(48, 32);

  private static List<Image> pictures(int count, double offset, double noise, long seed) {
    Random random = new Random(seed);
    List<Image> pictures = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      pictures.add(
          TestPictures.of(
              48,
              32,
              (x, y, c) ->
                  TestPictures.patternAt(x, y, c, 48, 32)
                      + offset
                      + noise * random.nextGaussian()));
    }
    return pictures;
  }

  private static double expected(double offset) {
    double sum = 0;
    for (double r : PictureError.seen(TRUTH)) {
      sum += offset * offset / (r * r + PictureError.FLOOR);
    }
    return sum / PictureError.seen(TRUTH).length;
  }

  @Test
  void biasIsFoundUnderNoise() {
    TradeRow.Bias bias = TradeStudy.bias(pictures(16, .05, .2, 1), TRUTH, 0);
    assertThat(bias.isDetected()).isTrue();
    assertThat(bias.squared()).isCloseTo(expected(.05), within(.1 * expected(.05)));
    assertThat(bias.low()).isLessThan(expected(.05));
    assertThat(bias.high()).isGreaterThan(expected(.05));
  }

  /**
   * Of 200 sets without bias, 2.5 % may have an interval that indicates one; 20 would be 6 sigma.
   */
  @Test
  void noiseIsNotTakenForBias() {
    int detected = 0;
    double sum = 0;
    for (int i = 0; i < 200; i++) {
      TradeRow.Bias bias = TradeStudy.bias(pictures(4, 0, .2, 100 + i), TRUTH, 0);
      detected += bias.isDetected() ? 1 : 0;
      sum += bias.squared() / 200;
    }
    assertThat(detected).isLessThan(20);
    // The squared noise of four seeds, which an estimate without its own variance would report.
    assertThat(sum).isCloseTo(0, within(.02 * expected(.1)));
  }

  @Test
  void theReferencesOwnNoiseIsTakenOff() {
    List<Image> same = pictures(4, 0, 0, 1);
    TradeRow.Bias bias = TradeStudy.bias(same, TRUTH, .01);
    assertThat(bias.squared()).isCloseTo(-.01, within(1e-9));
    assertThat(bias.high()).isEqualTo(.01);
  }

  private static TradeRow row(String value, Double... cpuSeconds) {
    TradeSetting setting =
        new TradeSetting(Knob.SAMPLER, value, TradeSetting.Kind.NOISE, "", null, null, null, null);
    PictureError error = new PictureError(.1, .01, 0, .3, .4, .9, .1);
    List<TradeShot> seeds =
        Stream.of(cpuSeconds)
            .map(time -> new TradeShot(setting, 16, 1, new Cost(time, time, 0), error, TRUTH))
            .toList();
    return new TradeRow(seeds, new TradeWork(2, 1, 5, 0), null);
  }

  /** Their ratios would be arbitrary, with unlimited intervals. */
  @Test
  void gainsOfRendersThatAreTooShortForTheClockAreNotTold() {
    TradeRow usual = row("sobol", .02, .02);
    TradeRow slow = row("independent", .04, .04);
    TradeRow brief = row("other", .01, 0.);
    TradeResult result = new TradeResult(TRUTH, 64, null, List.of(usual, slow, brief), List.of());
    assertThat(result.gain(slow).orElseThrow().value()).isCloseTo(.5, within(1e-12));
    assertThat(result.gain(brief)).isEmpty();
  }

  @Test
  void intervalsAreStudents() {
    Interval interval = Interval.ofMean(List.of(1.0, 2.0, 3.0));
    assertThat(interval.value()).isEqualTo(2);
    // 4.303 / sqrt(3)
    assertThat(interval.high()).isCloseTo(2 + 2.4843, within(1e-3));
    assertThat(Interval.ofMean(List.of(5.0))).isEqualTo(new Interval(5, 5, 5));
  }
}
