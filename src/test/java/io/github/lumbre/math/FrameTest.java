package io.github.lumbre.math;

import static io.github.lumbre.testing.Draws.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.testing.Effort;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests that frames are orthonormal and keep their handedness. */
class FrameTest {
  private static final double EPS = 0x1p-52;

  private final SplittableRandom random = new SplittableRandom(Effort.seed(4));

  private static void assertOrthonormal(Frame frame) {
    Vec3 t = frame.tangent();
    Vec3 b = frame.bitangent();
    Vec3 n = frame.normal();
    Vec3 errors = new Vec3(t.dot(b), b.dot(n), n.dot(t));
    assertThat(errors.maxAbs()).as("%s", frame).isLessThanOrEqualTo(4 * EPS);
    assertThat(t.length()).isCloseTo(1, within(4 * EPS));
    assertThat(b.length()).isCloseTo(1, within(4 * EPS));
  }

  private static double handedness(Frame frame) {
    return frame.tangent().cross(frame.bitangent()).dot(frame.normal());
  }

  @Test
  void framesAroundNormalsAreOrthonormalAndOfOneHandedness() {
    for (int i = 0; i < Effort.count(100_000, 1_000_000); i++) {
      Frame frame = Frame.around(direction(random));
      assertOrthonormal(frame);
      assertThat(handedness(frame)).isCloseTo(1, within(8 * EPS));
    }
  }

  @Test
  void framesAroundNormalsNearMinusZAreOrthonormal() {
    assertOrthonormal(Frame.around(Vec3.Z.negated()));
    assertOrthonormal(Frame.around(new Vec3(0, 0, -1 + EPS / 2)));
    assertOrthonormal(Frame.around(new Vec3(-0.0, -0.0, -1)));
    for (double tiny = 1e-300; tiny < .1; tiny *= 7) {
      assertOrthonormal(Frame.around(new Vec3(tiny, -2 * tiny, -1).normalized()));
      assertOrthonormal(Frame.around(new Vec3(1, -2, tiny).normalized()));
      assertOrthonormal(Frame.around(new Vec3(1, -2, -tiny).normalized()));
    }
  }

  @Test
  void givenTangentsAreKeptWithTheirHandedness() {
    for (int i = 0; i < 10_000; i++) {
      Vec3 n = direction(random);
      Vec3 u = direction(random).times(random.nextDouble(.01, 100));
      Vec3 v = direction(random);
      Frame frame = Frame.around(n, u, v);
      assertOrthonormal(frame);
      assertThat(frame.normal()).isEqualTo(n);
      assertThat(frame.tangent().dot(u)).isPositive();
      assertThat(frame.bitangent().dot(v)).isPositive();
      // The tangent stays in the plane of u and the normal.
      assertThat(frame.bitangent().dot(u)).isCloseTo(0, within(8 * EPS * u.length()));
    }
  }

  @Test
  void mirroredTangentsGiveMirroredFrames() {
    Frame right = Frame.around(Vec3.Z, Vec3.X, Vec3.Y);
    Frame left = Frame.around(Vec3.Z, Vec3.X, Vec3.Y.negated());
    assertThat(handedness(right)).isEqualTo(1);
    assertThat(handedness(left)).isEqualTo(-1);
    assertThat(left.tangent()).isEqualTo(right.tangent());
  }

  @Test
  void tangentsAlmostAlongTheNormalStillGiveOrthonormalFrames() {
    for (double tilt = 1e-11; tilt < 1; tilt *= 3) {
      Vec3 n = direction(random);
      Vec3 u = n.plus(tilt, Frame.around(n).tangent());
      assertOrthonormal(Frame.around(n, u, direction(random)));
    }
  }

  @Test
  void degenerateTangentsFallBackToTheFrameOfTheNormal() {
    Vec3 n = direction(random);
    Vec3 nan = new Vec3(Double.NaN, 0, 0);
    Vec3 infinite = new Vec3(Double.POSITIVE_INFINITY, 0, 0);
    for (Vec3 u : new Vec3[] {Vec3.ZERO, n, n.times(-1e9), nan, infinite}) {
      assertThat(Frame.around(n, u, direction(random))).isEqualTo(Frame.around(n));
    }
  }

  @Test
  void localAndWorldUndoEachOther() {
    for (int i = 0; i < 10_000; i++) {
      Frame frame = Frame.around(direction(random));
      Vec3 v = direction(random);
      assertThat(frame.toWorld(frame.toLocal(v)).minus(v).length()).isLessThan(8 * EPS);
      assertThat(frame.toLocal(frame.normal()).minus(Vec3.Z).length()).isLessThan(4 * EPS);
    }
  }

  /** A direction in the plane of the normal and the tangent lies on neither side. */
  @Test
  void bitangentsWithoutASideGiveTheHandednessOfFramesAroundNormals() {
    for (Vec3 v : new Vec3[] {Vec3.ZERO, Vec3.X, Vec3.Z}) {
      assertThat(handedness(Frame.around(Vec3.Z, Vec3.X, v))).isEqualTo(1);
    }
  }

  @Test
  void framesAreEqualIfAllThreeAxesAre() {
    Frame frame = new Frame(Vec3.X, Vec3.Y, Vec3.Z);
    assertThat(frame).isEqualTo(Frame.WORLD).hasSameHashCodeAs(Frame.WORLD);
    assertThat(frame).isNotEqualTo(new Frame(Vec3.X.negated(), Vec3.Y, Vec3.Z));
    assertThat(frame).isNotEqualTo(new Frame(Vec3.X, Vec3.Y.negated(), Vec3.Z));
    assertThat(frame).isNotEqualTo(new Frame(Vec3.X, Vec3.Y, Vec3.Z.negated()));
    assertThat(frame).isNotEqualTo(Vec3.X);
    assertThat(frame.hashCode()).isNotEqualTo(new Frame(Vec3.Y, Vec3.X, Vec3.Z).hashCode());
  }

  @Test
  void textNamesAllThreeAxes() {
    assertThat(Frame.WORLD).hasToString("Frame[" + Vec3.X + ", " + Vec3.Y + ", " + Vec3.Z + "]");
  }
}
