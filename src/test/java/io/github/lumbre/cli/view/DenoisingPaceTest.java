package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** When the picture of a render is denoised. */
class DenoisingPaceTest {
  private double rendered;

  @Test
  void quickOnesComeEverySecondOfRendering() {
    DenoisingPace pace = new DenoisingPace(() -> rendered);
    for (int i = 1; i < 5; i++) {
      rendered = i - .01;
      assertThat(pace.isDue()).isFalse();
      rendered = i;
      assertThat(pace.isDue()).isTrue();
      pace.spend(.02);
    }
  }

  @Test
  void slowOnesTakeThreePercentOfTheTime() {
    DenoisingPace pace = new DenoisingPace(() -> rendered);
    double spent = 0;
    for (rendered = 0; rendered < 5000; rendered += .25) {
      if (pace.isDue()) {
        double seconds = spent % 2 == 0 ? 1 : 3;
        spent += seconds;
        pace.spend(seconds);
      }
    }
    assertThat(spent / (rendered + spent)).isBetween(.025, .0305);
  }
}
