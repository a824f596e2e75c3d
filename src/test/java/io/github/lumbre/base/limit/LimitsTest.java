package io.github.lumbre.base.limit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.internal.TimeLimit;
import java.time.Duration;
import org.junit.jupiter.api.Test;

/** Tests ranges of limits, and the timer. */
class LimitsTest {
  @Test
  void valuesOutOfRangeAreNamed() {
    assertThatThrownBy(() -> Limits.UPLOADS.withBytes(0))
        .hasMessage("bytes: expected at least 1, found 0");
    assertThatThrownBy(() -> Limits.UPLOADS.withTriangles(-1))
        .hasMessage("triangles: expected at least 0, found -1");
    assertThatThrownBy(() -> Limits.UPLOADS.withTime(Duration.ZERO))
        .hasMessage("time: expected more than 0 s and at most 200 years, found PT0S");
  }

  @Test
  void timeThatPassesInterruptsAndIsCleared() throws InterruptedException {
    try (TimeLimit limit = TimeLimit.start(Duration.ofMillis(20))) {
      assertThatThrownBy(() -> Thread.sleep(60_000)).isInstanceOf(InterruptedException.class);
      assertThat(limit.hasPassed()).isTrue();
      Thread.currentThread().interrupt();
    }
    assertThat(Thread.currentThread().isInterrupted()).isFalse();
  }

  @Test
  void closedLimitInterruptsNobody() throws InterruptedException {
    TimeLimit limit = TimeLimit.start(Duration.ofMillis(20));
    limit.close();
    Thread.sleep(100);
    assertThat(limit.hasPassed()).isFalse();
  }

  @Test
  void closingKeepsAnInterruptFromOutside() {
    try (TimeLimit limit = TimeLimit.start(Duration.ofHours(1))) {
      Thread.currentThread().interrupt();
      assertThat(limit.hasPassed()).isFalse();
    }
    assertThat(Thread.interrupted()).isTrue();
  }
}
