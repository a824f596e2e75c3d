package io.github.lumbre.geometry.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SphereMirrorTest {
  private final SplittableRandom random = new SplittableRandom(3);

  private Vec3 direction() {
    while (true) {
      Vec3 v =
          new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
      if (v.length() > .1 && v.length() < 1) {
        return v.normalized();
      }
    }
  }

  /** A distance from the center between the radius and a million radii. */
  private double distance() {
    return 1 + Math.pow(10, random.nextDouble(-6, 6));
  }

  private static Vec3 reflected(Vec3 direction, Vec3 normal) {
    return direction.plus(-2 * direction.dot(normal), normal);
  }

  @Test
  void lightIsReflectedFromTheOnePointToTheOther() {
    int found = 0;
    for (int i = 0; i < 100_000; i++) {
      SphereMirror mirror = new SphereMirror(direction().times(3), random.nextDouble(.1, 10));
      Vec3 from = mirror.center().plus(mirror.radius() * distance(), direction());
      Vec3 to = mirror.center().plus(mirror.radius() * distance(), direction());
      Vec3 normal = mirror.normalBetween(from, to);
      if (normal.equals(Vec3.ZERO)) {
        assertThat(mirror.normalBetween(to, from)).isEqualTo(Vec3.ZERO);
        continue;
      }
      found++;
      Vec3 at = mirror.center().plus(mirror.radius(), normal);
      Vec3 incident = at.minus(from).normalized();
      Vec3 outgoing = to.minus(at).normalized();
      assertThat(normal.length()).isCloseTo(1, within(1e-15));
      assertThat(incident.dot(normal)).isLessThanOrEqualTo(1e-9);
      double closest = Math.min(at.minus(from).length(), to.minus(at).length());
      double tolerance = 1e-12 + 1e-14 * mirror.radius() / closest;
      assertThat(reflected(incident, normal).minus(outgoing).length()).isLessThan(tolerance);
    }
    assertThat(found).isBetween(50_000, 99_000);
  }

  /** Every point outside that a reflected ray reaches has that reflection. */
  @Test
  void everyReflectionIsFound() {
    SphereMirror mirror = new SphereMirror(new Vec3(1, 2, -3), 2);
    for (int i = 0; i < 100_000; i++) {
      Vec3 normal = direction();
      Vec3 away = direction();
      Vec3 incident = away.dot(normal) < 0 ? away : away.negated();
      Vec3 at = mirror.center().plus(mirror.radius(), normal);
      Vec3 from = at.plus(-mirror.radius() * (distance() - 1), incident);
      Vec3 to = at.plus(mirror.radius() * (distance() - 1), reflected(incident, normal));
      double grazing = -incident.dot(normal);
      if (grazing > 1e-3) {
        assertThat(mirror.normalBetween(from, to).minus(normal).length())
            .isLessThan(1e-8 / grazing);
      }
    }
  }

  @Test
  void nothingIsReflectedInsideOrBehind() {
    SphereMirror mirror = new SphereMirror(Vec3.ZERO, 1);
    assertThat(mirror.normalBetween(new Vec3(.5, 0, 0), new Vec3(3, 0, 0))).isEqualTo(Vec3.ZERO);
    assertThat(mirror.normalBetween(new Vec3(3, 0, 0), new Vec3(.5, 0, 0))).isEqualTo(Vec3.ZERO);
    assertThat(mirror.normalBetween(Vec3.ZERO, Vec3.ZERO)).isEqualTo(Vec3.ZERO);
    assertThat(mirror.normalBetween(new Vec3(3, 0, 0), new Vec3(-3, 0, 0))).isEqualTo(Vec3.ZERO);
    assertThat(mirror.normalBetween(new Vec3(3, 0, 0), new Vec3(-3, .1, 0))).isEqualTo(Vec3.ZERO);
    assertThat(mirror.normalBetween(new Vec3(3, 0, 0), new Vec3(5, 0, 0))).isEqualTo(Vec3.X);
    assertThat(mirror.normalBetween(new Vec3(3, 0, 0), new Vec3(3, 0, 0))).isEqualTo(Vec3.X);
    assertThat(mirror.normalBetween(new Vec3(Double.NaN, 0, 0), Vec3.X)).isEqualTo(Vec3.ZERO);
    assertThat(mirror.normalBetween(new Vec3(Double.POSITIVE_INFINITY, 0, 0), Vec3.X.times(2)))
        .isEqualTo(Vec3.ZERO);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-140, 1e-9, 1, 1e9, 1e140})
  void sizesMakeNoDifference(double size) {
    Vec3 from = new Vec3(3, 1, 0);
    Vec3 to = new Vec3(0, 2, 5);
    Vec3 expected = new SphereMirror(Vec3.ZERO, 1).normalBetween(from, to);
    Vec3 found = new SphereMirror(Vec3.ZERO, size).normalBetween(from.times(size), to.times(size));
    assertThat(found.minus(expected).length()).isLessThan(1e-14);
  }

  /** Compares the ratio with that of triangles of directions to three nearby points. */
  @Test
  void beamsNarrowAsDifferencesOfDirections() {
    for (int i = 0; i < 10_000; i++) {
      SphereMirror mirror = new SphereMirror(direction(), random.nextDouble(.5, 2));
      Vec3 from = mirror.center().plus(mirror.radius() * random.nextDouble(1.2, 8), direction());
      Vec3 to = mirror.center().plus(mirror.radius() * random.nextDouble(1.2, 8), direction());
      Vec3 normal = direction();
      Vec3 onMirror = mirror.normalBetween(from, to);
      if (onMirror.equals(Vec3.ZERO)) {
        continue;
      }
      Vec3 at = mirror.center().plus(mirror.radius(), onMirror);
      double cosine = -onMirror.dot(at.minus(from).normalized());
      double slant = Math.abs(normal.dot(to.minus(at).normalized()));
      double direct = Math.abs(normal.dot(to.minus(mirror.center()).normalized()));
      if (Math.min(cosine, Math.min(slant, direct)) < .2) {
        continue;
      }
      double step = 1e-6;
      Vec3 along = normal.cross(direction()).normalized();
      Vec3 u = along.times(step);
      Vec3 v = along.cross(normal).times(step);
      double seen =
          solidAngle(
              towards(mirror, from, to.minus(u), to.plus(u)),
              towards(mirror, from, to.minus(v), to.plus(v)));
      double fromCenter =
          solidAngle(
              difference(mirror.center(), to.minus(u), to.plus(u)),
              difference(mirror.center(), to.minus(v), to.plus(v)));
      assertThat(mirror.narrowing(from, at, to, normal) / (seen / fromCenter))
          .isCloseTo(1, within(1e-6));
    }
  }

  private static Vec3 difference(Vec3 from, Vec3 first, Vec3 second) {
    return second.minus(from).normalized().minus(first.minus(from).normalized());
  }

  private static Vec3 towards(SphereMirror mirror, Vec3 from, Vec3 first, Vec3 second) {
    Vec3 a = mirror.center().plus(mirror.radius(), mirror.normalBetween(from, first));
    Vec3 b = mirror.center().plus(mirror.radius(), mirror.normalBetween(from, second));
    return difference(from, a, b);
  }

  private static double solidAngle(Vec3 u, Vec3 v) {
    return u.cross(v).length();
  }

  @Test
  void onlyRoundSpheresAreMirrors() {
    Transform turned = Transform.rotationDegrees(new Vec3(20, 30, 40));
    Transform moved = Transform.translation(new Vec3(1, 2, 3)).times(turned);
    Sphere round = new Sphere(moved.times(Transform.scale(new Vec3(2, -2, 2))), 3);
    SphereMirror mirror = SphereMirror.of(round).orElseThrow();
    assertThat(mirror.radius()).isCloseTo(6, within(1e-14));
    assertThat(mirror.center().minus(new Vec3(1, 2, 3)).length()).isLessThan(1e-14);
    assertThat(SphereMirror.of(new Sphere(Transform.scale(new Vec3(2, 2, 2.001)), 3))).isEmpty();
    assertThat(SphereMirror.of(new Sphere(Transform.scale(new Vec3(2, 2.001, 2)), 3))).isEmpty();
    Transform sheared = Transform.scale(new Vec3(1, 2, 1)).times(turned);
    assertThat(SphereMirror.of(new Sphere(sheared, 3))).isEmpty();
  }
}
