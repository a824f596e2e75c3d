package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Tests how the errors and rays of a trial decide whether paths are guided. */
class GuideTrialTest {
  private static final int PIXELS = 1600;

  private static double[] all(double error) {
    double[] errors = new double[PIXELS];
    Arrays.fill(errors, error);
    return errors;
  }

  @Test
  void theGainIsTheRatioOfErrorTimesRays() {
    GuideTrial.Outcome half = GuideTrial.judge(all(2), all(1), 300, 400);
    assertThat(half.gain()).isCloseTo(1.5, within(1e-12));
    assertThat(half.isBetter()).isTrue();
    assertThat(half.rays()).isEqualTo(700);
    assertThat(GuideTrial.judge(all(2), all(1), 100, 160).gain()).isCloseTo(1.25, within(1e-12));
  }

  /** A gain below 1.3 does not make up for the time of guided rays. */
  @Test
  void smallGainsAreNotTaken() {
    assertThat(GuideTrial.judge(all(1.29), all(1), 1, 1).isBetter()).isFalse();
    assertThat(GuideTrial.judge(all(1.31), all(1), 1, 1).isBetter()).isTrue();
    assertThat(GuideTrial.judge(all(0), all(0), 1, 1))
        .isEqualTo(new GuideTrial.Outcome(1, false, 2));
  }

  /** One pixel of a hundred is a thousand times as noisy without the guide. */
  @Test
  void fewPixelsDoNotDecide() {
    double[] before = all(1);
    for (int i = 0; i < PIXELS; i += 100) {
      before[i] = 1000;
    }
    assertThat(GuideTrial.judge(before, all(1), 1, 1).gain()).isEqualTo(1);
  }

  /** One group of pixels has all of the gain of 1.6: another choice of pixels could have none. */
  @Test
  void uncertainGainsAreNotTaken() {
    double[] before = all(1);
    for (int i = 0; i < PIXELS; i += 16) {
      before[i] = 11;
    }
    GuideTrial.Outcome outcome = GuideTrial.judge(before, all(1), 1, 1);
    assertThat(outcome.gain()).isCloseTo(1.625, within(1e-12));
    assertThat(outcome.isBetter()).isFalse();
  }
}
