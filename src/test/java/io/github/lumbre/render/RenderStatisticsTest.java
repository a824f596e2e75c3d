package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.RenderStatistics.RejectedSample;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests the sums of render statistics. */
class RenderStatisticsTest {
  private static final RenderStatistics ONE =
      new RenderStatistics(1, 2, 3, 4, List.of(new RejectedSample(5, 1, 0)), 5, 6, 7, 8);

  private static final RenderStatistics OTHER =
      new RenderStatistics(10, 20, 30, 40, List.of(new RejectedSample(2, 1, 0)), 50, 60, 70, 80);

  @Test
  void allThatWasDoneIsSummed() {
    assertThat(ONE.plus(OTHER))
        .isEqualTo(
            new RenderStatistics(
                11,
                22,
                33,
                44,
                List.of(new RejectedSample(2, 1, 0), new RejectedSample(5, 1, 0)),
                55,
                66,
                77,
                88));
    assertThat(ONE.plus(RenderStatistics.ZERO)).isEqualTo(ONE);
    assertThat(RenderStatistics.ZERO.plus(ONE)).isEqualTo(ONE);
  }

  @Test
  void faultsAreNoWork() {
    assertThat(ONE.faults())
        .isEqualTo(new RenderStatistics(0, 0, 0, 4, ONE.firstRejected(), 5, 0, 0, 0));
    assertThat(RenderStatistics.ofFaults(4, ONE.firstRejected(), 5)).isEqualTo(ONE.faults());
  }

  /** For any division of the work, the first ten rejected samples in reading order are reported. */
  @Test
  void firstRejectedSamplesDoNotDependOnTheWorkers() {
    List<RejectedSample> all = new ArrayList<>();
    for (int i = 0; i < 24; i++) {
      all.add(new RejectedSample(i / 2 % 3, i / 6, i % 2));
    }
    for (int run = 0; run < 20; run++) {
      List<RejectedSample> shuffled = new ArrayList<>(all);
      Collections.shuffle(shuffled, new Random(run));
      RenderStatistics sum = RenderStatistics.ZERO;
      for (RejectedSample sample : shuffled) {
        sum = sum.plus(RenderStatistics.ofFaults(1, List.of(sample), 0));
      }
      assertThat(sum.rejected()).isEqualTo(24);
      assertThat(sum.firstRejected()).isEqualTo(all.subList(0, 10));
    }
  }
}
