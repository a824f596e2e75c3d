package io.github.lumbre.testing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Tests the seeds and the effort of quick builds. */
class EffortTest {
  @Test
  void quickBuildsRepeatThemselves() {
    if (Effort.isExhaustive()) {
      assertThat(Effort.count(10, 1000)).isEqualTo(1000);
    } else {
      assertThat(Effort.count(10, 1000)).isEqualTo(10);
      assertThat(Effort.seed(7)).isEqualTo(7);
    }
    assertThat(Effort.seed(7)).isEqualTo(Effort.seed(7)).isNotEqualTo(Effort.seed(8));
  }

  @Test
  @Tag(Effort.EXHAUSTIVE)
  void longTestsRunInExhaustiveBuildsOnly() {
    assertThat(Effort.isExhaustive()).isTrue();
  }
}
