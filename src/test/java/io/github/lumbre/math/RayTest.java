package io.github.lumbre.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RayTest {
  private static final Vec3 ORIGIN = new Vec3(1, 2, 3);
  private static final Vec3 DIRECTION = new Vec3(0, -2, 4);

  @Test
  void pointsLieFromTheOriginAlongTheDirection() {
    Ray ray = new Ray(ORIGIN, DIRECTION);
    assertThat(ray.at(0)).isEqualTo(ORIGIN);
    assertThat(ray.at(1)).isEqualTo(ORIGIN.plus(DIRECTION));
    assertThat(ray.at(.5)).isEqualTo(new Vec3(1, 1, 5));
  }

  @Test
  void rayWithoutAnEndReachesEveryDistance() {
    assertThat(new Ray(ORIGIN, DIRECTION).tMax()).isEqualTo(Double.POSITIVE_INFINITY);
  }
}
