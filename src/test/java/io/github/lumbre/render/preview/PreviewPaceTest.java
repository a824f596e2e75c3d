package io.github.lumbre.render.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever a preview costs, all after the first take at most the share and the credit. */
class PreviewPaceTest {
  private static final double SHARE = .01;
  private static final long CREDIT = 100_000_000;
  private static final long MILLISECOND = 1_000_000;

  @ParameterizedTest
  @ValueSource(longs = {0, 1, 7, 30, 99})
  void shareIsBounded(long costMillis) {
    AtomicLong time = new AtomicLong(Long.MAX_VALUE - 5_000_000_000L); // the clock overflows
    long start = time.get();
    PreviewPace pace = new PreviewPace(SHARE, CREDIT, time::get);
    assertThat(pace.isDue()).isFalse();
    long spent = 0;
    int count = 0;
    for (int i = 0; i < 200_000; i++) {
      if (pace.isDue()) {
        time.addAndGet(costMillis * MILLISECOND);
        pace.spend(costMillis * MILLISECOND);
        spent += count == 0 ? 0 : costMillis * MILLISECOND;
        count++;
        assertThat((double) spent).isLessThanOrEqualTo(CREDIT + SHARE * (time.get() - start) + 1);
      }
      time.addAndGet(MILLISECOND);
    }
    // As many as the share allows, or one each fifth of a second.
    double allowed =
        (CREDIT + SHARE * (time.get() - start)) / Math.max(1, costMillis * MILLISECOND);
    double inTime = (time.get() - start) / (double) PreviewPace.LEAST_NANOS;
    assertThat((double) count).isGreaterThan(.98 * Math.min(allowed, inTime) - 2);
  }
}
