package io.github.lumbre.scenefile.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The angles of a frame turn the world's axes to it. */
class RotationsTest {
  private static void assertRoundTrip(Vec3 degrees) {
    Transform turn = Transform.rotationDegrees(degrees);
    Frame axes = new Frame(turn.vector(Vec3.X), turn.vector(Vec3.Y), turn.vector(Vec3.Z));
    Transform again = Transform.rotationDegrees(Rotations.degrees(axes));
    for (Vec3 axis : new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}) {
      assertThat(again.vector(axis).minus(turn.vector(axis)).length())
          .as("%s", degrees)
          .isLessThan(1e-7);
    }
  }

  @Test
  void anglesRoundTrip() {
    SplittableRandom random = new SplittableRandom(63);
    for (int i = 0; i < 1000; i++) {
      assertRoundTrip(
          new Vec3(
              random.nextDouble(-180, 180),
              random.nextDouble(-180, 180),
              random.nextDouble(-180, 180)));
    }
  }

  @Test
  void polesAndQuarterTurnsRoundTrip() {
    for (int x = -180; x <= 180; x += 90) {
      for (int y = -180; y <= 180; y += 45) {
        for (int z = -180; z <= 180; z += 45) {
          assertRoundTrip(new Vec3(x, y, z));
        }
      }
    }
  }
}
