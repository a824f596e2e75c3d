package io.github.lumbre.integrator;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.scene.Scene;
import io.github.lumbre.testing.TestScenes;
import org.junit.jupiter.api.Test;

/** Tests which points of surfaces see each other. */
class GuideSightTest {
  /** A ball floats above a floor. Points lie on surfaces up to the rounding of a float. */
  @Test
  void onlyWhatLiesBetweenBlocksTheSight() {
    Scene scene =
        TestScenes.empty()
            .add(TestScenes.floor(), TestScenes.matte(.5))
            .add(TestScenes.sphere(0, 1, 0, .5), TestScenes.matte(.5))
            .build();
    GuideSight sight = new GuideSight(scene);
    double rounding = -1e-7;
    assertThat(sight.isClear(0, rounding, 0, 0, .5 - 2 * rounding, 0)).isTrue();
    assertThat(sight.isClear(0, rounding, 0, 0, 1.5, 0)).isFalse();
    assertThat(sight.isClear(.6, rounding, 0, 0, 9, 0)).isTrue();
    assertThat(sight.isClear(.6, 1, 0, 0, -2, 0)).isFalse();
  }
}
