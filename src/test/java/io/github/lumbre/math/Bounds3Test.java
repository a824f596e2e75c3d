package io.github.lumbre.math;

import static io.github.lumbre.testing.Draws.inCube;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests bounding boxes. */
class Bounds3Test {
  private static final Vec3 LOW = new Vec3(-1, -2, -3);
  private static final Vec3 HIGH = new Vec3(4, 5, 6);

  @Test
  void boxAroundPointsIsTheSmallest() {
    Bounds3 box = Bounds3.of(new Vec3(4, -2, 0), new Vec3(-1, 5, 6), new Vec3(0, 0, -3));
    assertThat(box).isEqualTo(new Bounds3(LOW, HIGH));
    assertThat(box.center()).isEqualTo(new Vec3(1.5, 1.5, 1.5));
    assertThat(box.radius()).isEqualTo(new Vec3(2.5, 3.5, 4.5).length());
  }

  @Test
  void emptyBoxIsNeutral() {
    Bounds3 box = new Bounds3(LOW, HIGH);
    assertThat(Bounds3.EMPTY.union(box)).isEqualTo(box);
    assertThat(box.union(Bounds3.EMPTY)).isEqualTo(box);
    assertThat(Bounds3.of()).isEqualTo(Bounds3.EMPTY);
    assertThat(Bounds3.EMPTY.isEmpty()).isTrue();
    assertThat(Bounds3.EMPTY.radius()).isZero();
  }

  @Test
  void flatBoxIsNotEmpty() {
    Bounds3 point = Bounds3.of(HIGH);
    assertThat(point.isEmpty()).isFalse();
    assertThat(point.radius()).isZero();
    assertThat(point.center()).isEqualTo(HIGH);
  }

  @Test
  void boxWithoutNumbersIsEmpty() {
    assertThat(new Bounds3(new Vec3(Double.NaN, 0, 0), HIGH).isEmpty()).isTrue();
    assertThat(new Bounds3(HIGH, LOW).isEmpty()).isTrue();
  }

  @Test
  void cornersAreCountedInBinary() {
    Bounds3 box = new Bounds3(LOW, HIGH);
    assertThat(box.corner(0)).isEqualTo(LOW);
    assertThat(box.corner(1)).isEqualTo(new Vec3(4, -2, -3));
    assertThat(box.corner(2)).isEqualTo(new Vec3(-1, 5, -3));
    assertThat(box.corner(4)).isEqualTo(new Vec3(-1, -2, 6));
    assertThat(box.corner(7)).isEqualTo(HIGH);
  }

  @Test
  void hugeBoxesHaveFiniteCenterAndRadius() {
    double huge = 1e308;
    Bounds3 box = Bounds3.of(new Vec3(-huge, huge, huge), new Vec3(huge, huge, huge));
    assertThat(box.isFinite()).isTrue();
    assertThat(box.center()).isEqualTo(new Vec3(0, huge, huge));
    assertThat(box.radius()).isEqualTo(huge);
    assertThat(new Bounds3(LOW, new Vec3(1, Double.POSITIVE_INFINITY, 1)).isFinite()).isFalse();
  }

  /** Compares with points of the segment. */
  @Test
  void segmentsMeetTheBoxesThatTheyPass() {
    SplittableRandom random = new SplittableRandom(3);
    Bounds3 box = new Bounds3(LOW, HIGH);
    int met = 0;
    for (int i = 0; i < 2000; i++) {
      Vec3 a = inCube(random, 12);
      Vec3 b = inCube(random, 12);
      boolean passes = false;
      for (int step = 0; step <= 2000; step++) {
        Vec3 p = a.plus(step / 2000.0, b.minus(a));
        passes |=
            p.x() >= LOW.x()
                && p.x() <= HIGH.x()
                && p.y() >= LOW.y()
                && p.y() <= HIGH.y()
                && p.z() >= LOW.z()
                && p.z() <= HIGH.z();
      }
      assertThat(!passes || box.meets(a, b)).isTrue();
      met += box.meets(a, b) == passes ? 1 : 0;
    }
    // A segment that cuts a corner off may pass between two points.
    assertThat(met).isGreaterThan(1990);
  }

  @Test
  void anyMayMeetAnInfiniteBox() {
    double infinite = Double.POSITIVE_INFINITY;
    Vec3 corner = new Vec3(infinite, infinite, infinite);
    assertThat(new Bounds3(corner.negated(), corner).meets(LOW, HIGH)).isTrue();
  }
}
