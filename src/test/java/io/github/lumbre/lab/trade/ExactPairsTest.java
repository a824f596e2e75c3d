package io.github.lumbre.lab.trade;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests when a ratio of times is told. */
class ExactPairsTest {
  @Test
  void shortTimesHaveNoRatio() {
    List<Double> enough = List.of(.4, .4, .4);
    List<Double> half = List.of(.2, .2, .2);
    assertThat(ExactPairs.ratio(enough, half).orElseThrow().value()).isEqualTo(2);
    assertThat(ExactPairs.ratio(half, enough).orElseThrow().value()).isEqualTo(.5);
    assertThat(ExactPairs.ratio(enough, List.of(.2, .2, .05))).isEmpty();
    assertThat(ExactPairs.ratio(List.of(.2, .005, .2), enough)).isEmpty();
    assertThat(ExactPairs.ratio(enough, List.of(0., .2, .2))).isEmpty();
  }
}
