package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.List;

/**
 * The transform of an object relative to its parent, as its keys state it.
 *
 * @param transform from the object's space to the parent's
 * @param turn the rotation alone, without a translation
 * @param isMatrix whether the object states a matrix
 */
record LocalTransform(Transform transform, Transform turn, boolean isMatrix) {
  /** The numbers of a matrix: three rows of four. */
  static final int NUMBERS = 12;

  /** The largest error of unit and perpendicular axes that are kept as they are. */
  private static final double ROUNDING = 1e-12;

  /** The largest error of a stated inverse, relative to the sum of its terms. */
  private static final double INVERSE_ERROR = 1e-9;

  /** Returns the transform of an object; adds errors to its problems. */
  static LocalTransform of(JsonNode node) {
    return ObjectKeys.MATRIX.isIn(node) ? ofMatrix(node) : ofParts(node);
  }

  private static LocalTransform ofParts(JsonNode node) {
    Vec3 position = ObjectKeys.POSITION.in(node);
    Transform turn = turn(node, position);
    Transform local =
        Transform.translation(position)
            .times(turn)
            .times(Transform.scale(ObjectKeys.SCALE.in(node)));
    return new LocalTransform(local, turn, false);
  }

  private static Transform turn(JsonNode node, Vec3 position) {
    Vec3 up = ObjectKeys.LOOK_AT_UP.in(node);
    if (!ObjectKeys.LOOK_AT.isIn(node)) {
      return Transform.rotationDegrees(ObjectKeys.ROTATION.in(node));
    }
    warnOfIgnored(node, List.of(ObjectKeys.ROTATION), ObjectKeys.LOOK_AT.name());
    Vec3 target = ObjectKeys.LOOK_AT.in(node);
    try {
      return Transform.ofFrame(Frame.lookingAt(position, target, up), Vec3.ZERO);
    } catch (IllegalArgumentException e) {
      node.error(
          ObjectKeys.LOOK_AT.name(),
          "expected a point other than localPosition, and lookAtUp not along the view; found "
              + "a view that is not determined");
      return Transform.IDENTITY;
    }
  }

  private static void warnOfIgnored(JsonNode node, List<Key<?>> keys, String by) {
    for (Key<?> key : keys) {
      if (key.isIn(node)) {
        node.warn(key.name(), "is ignored, because the object has " + by);
      }
    }
  }

  private static LocalTransform ofMatrix(JsonNode node) {
    warnOfIgnored(
        node,
        List.of(
            ObjectKeys.POSITION,
            ObjectKeys.ROTATION,
            ObjectKeys.SCALE,
            ObjectKeys.LOOK_AT,
            ObjectKeys.LOOK_AT_UP),
        "a matrix");
    double[] m = ObjectKeys.MATRIX.in(node);
    if (m.length == 0) {
      return new LocalTransform(Transform.IDENTITY, Transform.IDENTITY, true);
    }
    Transform matrix = m.length == NUMBERS ? computed(m) : stated(m);
    if (m.length != NUMBERS && !isInverse(matrix)) {
      node.error(
          ObjectKeys.MATRIX.name(),
          "expected the inverse of the matrix after it, found another matrix");
    }
    return new LocalTransform(matrix, rotation(matrix), true);
  }

  private static Transform computed(double[] m) {
    return Transform.ofAxes(
        new Vec3(m[0], m[4], m[8]),
        new Vec3(m[1], m[5], m[9]),
        new Vec3(m[2], m[6], m[10]),
        new Vec3(m[3], m[7], m[11]));
  }

  private static Transform stated(double[] m) {
    double[] values = new double[Transform.VALUES];
    for (int row = 0; row < 3; row++) {
      System.arraycopy(m, 4 * row, values, 3 * row, 3);
      values[18 + row] = m[4 * row + 3];
    }
    System.arraycopy(m, NUMBERS, values, 9, 9);
    values[Transform.VALUES - 1] = m[Transform.VALUES - 1];
    return Transform.ofArray(values);
  }

  private static boolean isInverse(Transform t) {
    double[] v = t.toArray();
    for (int i = 0; i < 9; i++) {
      double sum = 0;
      double size = 0;
      for (int k = 0; k < 3; k++) {
        double term = v[i / 3 * 3 + k] * v[9 + 3 * k + i % 3];
        sum += term;
        size += Math.abs(term);
      }
      if (!(Math.abs(sum - (i % 4 == 0 ? 1 : 0)) <= INVERSE_ERROR * Math.max(1, size))) {
        return false;
      }
    }
    return true;
  }

  /** Returns the numbers that state a transform bit for bit, as few as possible. */
  private static double[] numbers(Transform t) {
    double[] v = t.toArray();
    double[] all = new double[Transform.VALUES];
    for (int row = 0; row < 3; row++) {
      System.arraycopy(v, 3 * row, all, 4 * row, 3);
      all[4 * row + 3] = v[18 + row];
    }
    System.arraycopy(v, 9, all, NUMBERS, 9);
    all[Transform.VALUES - 1] = v[Transform.VALUES - 1];
    double[] few = Arrays.copyOf(all, NUMBERS);
    return Arrays.equals(computed(few).toArray(), v) ? few : all;
  }

  /** Writes a transform: a position if that has the same bits, otherwise a matrix. */
  static void place(JsonObject object, Transform transform) {
    Vec3 position = transform.point(Vec3.ZERO);
    Transform moved =
        Transform.translation(position)
            .times(Transform.rotationDegrees(Vec3.ZERO))
            .times(Transform.scale(new Vec3(1, 1, 1)));
    double[] values = transform.toArray();
    if (Arrays.equals(values, moved.toArray())
        && Arrays.equals(values, Transform.IDENTITY.times(moved).toArray())) {
      ObjectKeys.POSITION.put(object, position);
    } else {
      matrix(object, transform);
    }
  }

  /** Writes a transform as a matrix. */
  static void matrix(JsonObject object, Transform transform) {
    ObjectKeys.MATRIX.put(object, numbers(transform));
  }

  /** Returns the rotation of a map: its axes, if they are perpendicular unit vectors. */
  private static Transform rotation(Transform t) {
    Vec3 x = t.vector(Vec3.X);
    Vec3 y = t.vector(Vec3.Y);
    Vec3 z = t.vector(Vec3.Z);
    if (isOrthonormal(x, y, z)) {
      return Transform.ofAxes(x, y, z, Vec3.ZERO);
    }
    Vec3 forward = z.normalized();
    if (!forward.isFinite() || Frame.isAlong(forward, y)) {
      return Transform.IDENTITY;
    }
    Vec3 up = Frame.tangentAround(forward, y);
    return Transform.ofFrame(new Frame(up.cross(forward), up, forward), Vec3.ZERO);
  }

  private static boolean isOrthonormal(Vec3 x, Vec3 y, Vec3 z) {
    return Math.abs(x.lengthSquared() - 1) <= ROUNDING
        && Math.abs(y.lengthSquared() - 1) <= ROUNDING
        && Math.abs(z.lengthSquared() - 1) <= ROUNDING
        && Math.abs(x.dot(y)) <= ROUNDING
        && Math.abs(y.dot(z)) <= ROUNDING
        && Math.abs(z.dot(x)) <= ROUNDING;
  }
}
