package io.github.lumbre.lab.perf;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the detection of warm-up. */
class WarmUpTest {
  @Test
  void warmUpLastsUntilARenderIsAsFastAsThoseAfterwards() {
    assertThat(new WarmUp(List.of(3.0, 1.2, 1.04, 1.0), List.of(1.0, 9.0, .9)).text())
        .isEqualTo("4.20 s");
  }

  @Test
  void whatIsWarmAtOnceTookNoTime() {
    assertThat(new WarmUp(List.of(1.05, 1.0), List.of(1.0)).text()).isEqualTo("0.00 s");
  }

  @Test
  void unfinishedWarmUpIsMarked() {
    assertThat(new WarmUp(List.of(2.0, 1.5), List.of(1.0)).text()).isEqualTo("> 3.50 s");
  }

  @Test
  void noWarmUpTellsNothing() {
    assertThat(new WarmUp(List.of(), List.of()).text()).isEqualTo("-");
  }
}
