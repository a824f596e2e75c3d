package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests sampled surface points and their densities. */
class SurfaceSampleTest {
  @Test
  void samplesKeepWhatIsSet() {
    SurfaceSample sample = new SurfaceSample();
    assertThat(sample.pdf()).isZero();
    assertThat(sample.normal().length()).isEqualTo(1);
    sample.set(new Vec3(4, 5, 6), Vec3.Y, new TexturePoint(7, 8), 9, 10);
    assertThat(sample.position()).isEqualTo(new Vec3(4, 5, 6));
    assertThat(sample.normal()).isEqualTo(Vec3.Y);
    assertThat(sample.texture()).isEqualTo(new TexturePoint(7, 8));
    assertThat(sample.error()).isEqualTo(9);
    assertThat(sample.pdf()).isEqualTo(10);
    sample.clear();
    assertThat(sample.pdf()).isZero();
  }

  @Test
  void frontIsTheSideOfTheNormal() {
    Random random = new Random(3);
    SurfaceSample sample = new SurfaceSample();
    for (int i = 0; i < 300; i++) {
      Vec3 position = Shapes.point(random, 5);
      Vec3 normal = Shapes.direction(random);
      Vec3 from = Shapes.point(random, 5);
      sample.set(position, normal, new TexturePoint(0, 0), 0, 1);
      assertThat(sample.isSeenFrontally(from)).isEqualTo(from.minus(position).dot(normal) > 0);
    }
    sample.set(Vec3.ZERO, Vec3.Z, new TexturePoint(0, 0), 0, 1);
    assertThat(sample.isSeenFrontally(new Vec3(1, 2, 0))).isFalse();
  }

  /** The density is distance² / (|cos| area) from either side, or 0 where that is not finite. */
  @Test
  void densityOfAnAreaIsThatOfItsSolidAngle() {
    Vec3 way = new Vec3(0, 3, 4);
    assertThat(Placement.solidAnglePdf(way, Vec3.Y, 2)).isCloseTo(25 / (.6 * 2), within(1e-12));
    assertThat(Placement.solidAnglePdf(way, Vec3.Z.negated(), 2))
        .isCloseTo(25 / (.8 * 2), within(1e-12));
    assertThat(Placement.solidAnglePdf(way, Vec3.X, 2)).isZero();
    assertThat(Placement.solidAnglePdf(Vec3.ZERO, Vec3.X, 2)).isZero();
    assertThat(Placement.solidAnglePdf(way.times(1e200), Vec3.Y, 1e-10)).isZero();
  }
}
