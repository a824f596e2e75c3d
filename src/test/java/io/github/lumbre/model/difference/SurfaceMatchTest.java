package io.github.lumbre.model.difference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.difference.PartChange.Kind;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelMotions;
import io.github.lumbre.model.internal.ModelReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Parts are found again whatever triangles they are divided into. */
class SurfaceMatchTest {
  private final List<Vec3[]> triangles = new ArrayList<>();

  /** Adds a rectangle of n times n pieces. */
  private void face(Vec3 corner, Vec3 u, Vec3 v, int n) {
    for (int i = 0; i < n * n; i++) {
      Vec3 at = corner.plus(i / n / (double) n, u).plus(i % n / (double) n, v);
      Vec3 right = at.plus(1. / n, u);
      Vec3 both = right.plus(1. / n, v);
      triangles.add(new Vec3[] {at, right, both});
      triangles.add(new Vec3[] {at, both, at.plus(1. / n, v)});
    }
  }

  private void box(Vec3 low, Vec3 size, int n) {
    Vec3 x = new Vec3(size.x(), 0, 0);
    Vec3 y = new Vec3(0, size.y(), 0);
    Vec3 z = new Vec3(0, 0, size.z());
    face(low, y, x, n);
    face(low.plus(z), x, y, n);
    face(low, x, z, n);
    face(low.plus(y), z, x, n);
    face(low, z, y, n);
    face(low.plus(x), y, z, n);
  }

  private void rod(Vec3 from, double radius, double height, int sides) {
    for (int i = 0; i < sides; i++) {
      Vec3[] p = new Vec3[2];
      for (int k = 0; k < 2; k++) {
        double angle = 2 * Math.PI * (i + k) / sides;
        p[k] = from.plus(new Vec3(radius * Math.cos(angle), radius * Math.sin(angle), 0));
      }
      Vec3 up = new Vec3(0, 0, height);
      triangles.add(new Vec3[] {p[0], p[1], p[1].plus(up)});
      triangles.add(new Vec3[] {p[0], p[1].plus(up), p[0].plus(up)});
      triangles.add(new Vec3[] {from, p[1], p[0]});
      triangles.add(new Vec3[] {from.plus(up), p[0].plus(up), p[1].plus(up)});
    }
  }

  /** A bracket with a post and a tooth: no mirror makes it itself. */
  private static SurfaceMatchTest bracket(int n, int sides) {
    SurfaceMatchTest part = new SurfaceMatchTest();
    part.box(Vec3.ZERO, new Vec3(30, 10, 5), n);
    part.box(new Vec3(0, 0, 5), new Vec3(8, 10, 20), n + 1);
    part.box(new Vec3(25, 0, 5), new Vec3(5, 2, 4), n);
    part.rod(new Vec3(22, 5, 5), 3, 12, sides);
    return part;
  }

  private Model placed(Transform place) throws Exception {
    return placed(place, ModelOptions.DEFAULT);
  }

  private Model placed(Transform place, ModelOptions options) throws Exception {
    StringBuilder obj = new StringBuilder("o bracket\n");
    boolean isMirrored = place.determinant() < 0;
    for (Vec3[] t : triangles) {
      for (Vec3 p : t) {
        Vec3 q = place.point(p);
        obj.append("v %.7g %.7g %.7g\n".formatted(q.x(), q.y(), q.z()));
      }
      obj.append(isMirrored ? "f -3 -1 -2\n" : "f -3 -2 -1\n");
    }
    byte[] content = obj.toString().getBytes(StandardCharsets.US_ASCII);
    return ModelReader.read("part.obj", content, ModelFolder.NONE, options);
  }

  private static PartChange only(Model old, Model now) {
    double tolerance = ModelDifference.tolerance(old, now);
    ModelDifference.Result result =
        ModelDifference.between(
            new ModelDifference.Side(old, ModelMotions.NONE),
            new ModelDifference.Side(now, ModelMotions.NONE),
            tolerance);
    assertThat(result.changes()).hasSize(1);
    return result.changes().get(0);
  }

  @Test
  void aShiftIsFoundWithOtherTriangles() throws Exception {
    Transform place = Transform.translation(new Vec3(0, -8, 0));
    PartChange change =
        only(bracket(1, 80).placed(Transform.IDENTITY), bracket(3, 120).placed(place));
    assertThat(change.kind()).isEqualTo(Kind.MOVED);
    assertThat(FileSpace.WORLD.text(change.shift())).isEqualTo("(0, -8, 0)");
    assertThat(change.degrees()).isZero();
    assertThat(change.details().get(0)).isEqualTo("triangles 392 to 888");
    // The sagitta of the coarser rod is .0023, in a part of a size of 40.
    assertThat(change.details().get(1)).matches("surfaces at most 0[.]00[0-9]+ apart");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0,0,33", "120,40,-75", "0,180,0", "90,0,90"})
  void aRotationIsFoundWithOtherTriangles(String degrees) throws Exception {
    double[] d = List.of(degrees.split(",")).stream().mapToDouble(Double::valueOf).toArray();
    Transform place = Transform.placed(new Vec3(5, -8, 2.5), new Vec3(d[0], d[1], d[2]));
    PartChange change =
        only(bracket(1, 80).placed(Transform.IDENTITY), bracket(3, 120).placed(place));
    assertThat(change.kind()).isEqualTo(Kind.MOVED);
    double trace =
        place.vector(Vec3.X).x() + place.vector(Vec3.Y).y() + place.vector(Vec3.Z).z();
    double angle = Math.toDegrees(Math.acos(Math.max(-1, (trace - 1) / 2)));
    assertThat(change.degrees()).isCloseTo(angle, within(.05));
  }

  @Test
  void otherTrianglesAtThePlaceAreAChange() throws Exception {
    PartChange change =
        only(
            bracket(1, 80).placed(Transform.IDENTITY), bracket(3, 120).placed(Transform.IDENTITY));
    assertThat(change.kind()).isEqualTo(Kind.CHANGED);
    assertThat(change.details().get(0)).isEqualTo("triangles 392 to 888");
  }

  @Test
  void aMirroredPartIsAnotherOne() throws Exception {
    Transform place = Transform.scale(new Vec3(1, -1, 1));
    PartChange change =
        only(bracket(1, 80).placed(Transform.IDENTITY), bracket(3, 120).placed(place));
    assertThat(change.kind()).isEqualTo(Kind.CHANGED);
    assertThat(change.details()).noneMatch(detail -> detail.contains("apart"));
  }

  /** A plate of 100 mm with a hole of 1 mm: its rim divides the plate into strips. */
  private static SurfaceMatchTest plate(double hole) {
    SurfaceMatchTest part = new SurfaceMatchTest();
    double[] x = {0, hole - .5, hole + .5, 100};
    double[] y = {0, 49.5, 50.5, 100};
    for (int i = 0; i < 9; i++) {
      if (i != 4) {
        Vec3 low = new Vec3(x[i % 3], y[i / 3], 0);
        Vec3 u = new Vec3(x[i % 3 + 1] - x[i % 3], 0, 0);
        Vec3 v = new Vec3(0, y[i / 3 + 1] - y[i / 3], 0);
        part.face(low, v, u, 1);
        part.face(low.plus(2, Vec3.Z), u, v, 1);
      }
    }
    Vec3 up = new Vec3(0, 0, 2);
    part.face(new Vec3(hole - .5, 49.5, 0), up, Vec3.X, 1);
    part.face(new Vec3(hole - .5, 50.5, 0), Vec3.X, up, 1);
    return part;
  }

  @Test
  void aMovedHoleIsAChange() throws Exception {
    PartChange change =
        only(plate(50).placed(Transform.IDENTITY), plate(52).placed(Transform.IDENTITY));
    assertThat(change.kind()).isEqualTo(Kind.CHANGED);
    assertThat(change.details()).containsExactly("another shape");
  }

  @ParameterizedTest
  @CsvSource({"0, true", "0.03, true", "0.08, false"})
  void surfacesAreTheSameWithinAThousandthOfTheSize(double apart, boolean isSame)
      throws Exception {
    SurfaceMatchTest old = new SurfaceMatchTest();
    old.box(Vec3.ZERO, new Vec3(20, 20, 20), 2);
    SurfaceMatchTest now = new SurfaceMatchTest();
    // Both sides move by half of the difference.
    now.box(new Vec3(-apart / 2, 0, 0), new Vec3(20 + apart, 20, 20), 3);
    PartChange change = only(old.placed(Transform.IDENTITY), now.placed(Transform.IDENTITY));
    assertThat(change.kind()).isEqualTo(Kind.CHANGED);
    assertThat(change.details().stream().anyMatch(d -> d.endsWith("apart"))).isEqualTo(isSame);
  }

  /** Numbers are those of the file, whose z axis points up. */
  @Test
  void sizesAndMovesAreInTheAxesAndTheUnitOfTheFile() throws Exception {
    ModelOptions upright =
        new ModelOptions(Optional.empty(), Optional.empty(), ModelOptions.Up.Z, .001);
    SurfaceMatchTest part = bracket(1, 12);
    PartChange moved =
        only(
            part.placed(Transform.IDENTITY, upright),
            part.placed(Transform.translation(new Vec3(0, -8, .25)), upright));
    assertThat(FileSpace.WORLD.text(moved.shift())).isEqualTo("(0, -8, 0.25)");
    PartChange longer =
        only(
            part.placed(Transform.IDENTITY, upright),
            part.placed(Transform.scale(new Vec3(2, 1, 1)), upright));
    assertThat(longer.details()).contains("size 30 x 10 x 25 to 60 x 10 x 25");
  }
}
