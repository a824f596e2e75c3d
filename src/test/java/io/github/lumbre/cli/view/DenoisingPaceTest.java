package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** When the picture of a render is denoised. */
class DenoisingPaceTest {
  private final DenoisingPace pace = new DenoisingPace();

  @Test
  void quickOnesComeEverySecondOfRendering() {
    for (int i = 1; i < 5; i++) {
      assertThat(pace.isDue(i - .01)).isFalse();
      assertThat(pace.isDue(i)).isTrue();
      pace.spend(i, .02);
    }
  }

  @Test
  void slowOnesTakeThreePercentOfTheTime() {
    double spent = 0;
    double rendered = 0;
    for (; rendered < 5000; rendered += .25) {
      if (pace.isDue(rendered)) {
        double cost = spent % 2 == 0 ? 1 : 3;
        spent += cost;
        pace.spend(rendered, cost);
      }
    }
    assertThat(spent / (rendered + spent)).isBetween(.025, .0305);
  }

  @Test
  void onlyTheFirstOfAllRendersIsNotCounted() {
    pace.spend(1, 3);
    assertThat(pace.isDue(1.99)).isFalse();
    assertThat(pace.isDue(2)).isTrue();
    pace.restart();
    assertThat(pace.isDue(.99)).isFalse();
    assertThat(pace.isDue(1)).isTrue();
    pace.spend(1, 3);
    assertThat(pace.isDue(97.9)).isFalse();
    assertThat(pace.isDue(98.1)).isTrue();
  }
}
