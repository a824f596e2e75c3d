package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

/** Tests the grid of numbers of branches. */
class SplitPlanTest {
  private static final SplitPlan PLAN = new SplitPlan(10, 4, 3, 2, new byte[] {0, 1, 2, 3, 0, 1});

  @Test
  void eachPixelHasTheNumberOfItsCell() {
    assertThat(PLAN.branches(0, 0)).isEqualTo(1);
    assertThat(PLAN.branches(3, 1)).isEqualTo(1);
    assertThat(PLAN.branches(4, 1)).isEqualTo(2);
    assertThat(PLAN.branches(9, 0)).isEqualTo(4);
    assertThat(PLAN.branches(0, 2)).isEqualTo(8);
    assertThat(PLAN.branches(9, 3)).isEqualTo(2);
    assertThat(PLAN.meanBranches()).isEqualTo(3);
    assertThat(PLAN.share(1)).isEqualTo(1 / 3.);
    assertThat(PLAN.isEmpty()).isFalse();
    assertThat(SplitPlan.NONE.branches(1 << 20, 7)).isOne();
    assertThat(SplitPlan.NONE.isEmpty()).isTrue();
  }

  @Test
  void theHashDependsOnEveryNumber() {
    assertThat(PLAN.hash()).matches("[0-9a-f]{64}");
    byte[] other = {0, 1, 2, 3, 0, 0};
    assertThat(new SplitPlan(10, 4, 3, 2, other).hash()).isNotEqualTo(PLAN.hash());
    byte[] same = {0, 1, 2, 3, 0, 1};
    assertThat(new SplitPlan(10, 4, 3, 2, same).hash()).isEqualTo(PLAN.hash());
    assertThat(new SplitPlan(10, 4, 2, 3, same).hash()).isNotEqualTo(PLAN.hash());
  }

  @Test
  void aGridIsLimited() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new SplitPlan(1 << 9, 1 << 9, 1 << 8, 257, new byte[257 << 8]));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new SplitPlan(4, 4, 2, 2, new byte[3]))
        .withMessage("exponents: expected 4, found 3");
  }
}
