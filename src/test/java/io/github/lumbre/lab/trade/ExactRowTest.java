package io.github.lumbre.lab.trade;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests when a ratio of times is told. */
class ExactRowTest {
  @Test
  void shortTimesHaveNoRatio() {
    List<Double> enough = List.of(.4, .4, .4);
    List<Double> half = List.of(.2, .2, .2);
    assertThat(ExactRow.ratio(enough, half).orElseThrow().value()).isEqualTo(2);
    assertThat(ExactRow.ratio(half, enough).orElseThrow().value()).isEqualTo(.5);
    assertThat(ExactRow.ratio(enough, List.of(.2, .2, .05))).isEmpty();
    assertThat(ExactRow.ratio(List.of(.2, .005, .2), enough)).isEmpty();
    assertThat(ExactRow.ratio(enough, List.of(0., .2, .2))).isEmpty();
  }
}
