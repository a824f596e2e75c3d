package io.github.lumbre.model.format.dae;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.util.Optional;

/** The transforms of nodes (COLLADA 1.4.1, chapter 5). Wrong ones are ignored with a warning. */
final class DaeTransforms {
  private final DaeDocument document;

  DaeTransforms(DaeDocument document) {
    this.document = document;
  }

  /** Returns the product of a node's transforms, the first of which acts last. */
  Transform of(DaeElement node) {
    Transform all = Transform.IDENTITY;
    for (DaeElement child : node.children()) {
      Optional<Transform> each = transform(child);
      all = each.isPresent() ? all.times(each.get()) : all;
    }
    return all;
  }

  private Optional<Transform> transform(DaeElement element) {
    return switch (element.name()) {
      case "matrix" -> document.numbers(element, 16).map(m -> matrix(m, 0));
      case "translate" ->
          document.numbers(element, 3).map(v -> Transform.translation(vector(v, 0)));
      case "scale" -> document.numbers(element, 3).map(DaeTransforms::scale);
      case "rotate" ->
          document
              .numbers(element, 4)
              .filter(v -> v[3] != 0)
              .flatMap(v -> valid(rotation(v), element));
      case "lookat" -> document.numbers(element, 9).flatMap(v -> valid(lookAt(v), element));
      case "skew" -> document.numbers(element, 7).flatMap(v -> valid(skew(v), element));
      default -> Optional.empty();
    };
  }

  private static Vec3 vector(double[] v, int at) {
    return new Vec3(v[at], v[at + 1], v[at + 2]);
  }

  /**
   * Returns the affine map of a matrix, row by row.
   *
   * @param at the index of the first of 16 numbers
   */
  static Transform matrix(double[] m, int at) {
    return Transform.ofAxes(
        new Vec3(m[at], m[at + 4], m[at + 8]),
        new Vec3(m[at + 1], m[at + 5], m[at + 9]),
        new Vec3(m[at + 2], m[at + 6], m[at + 10]),
        new Vec3(m[at + 3], m[at + 7], m[at + 11]));
  }

  private static Transform scale(double... v) {
    return Transform.ofAxes(Vec3.X.times(v[0]), Vec3.Y.times(v[1]), Vec3.Z.times(v[2]), Vec3.ZERO);
  }

  /** Returns the rotation about an axis by an angle in degrees (Rodrigues 1840). */
  private static Transform rotation(double... v) {
    Vec3 axis = vector(v, 0).normalized();
    double sin = Elementary.sinDegrees(v[3]);
    double cos = Elementary.cosDegrees(v[3]);
    return Transform.ofAxes(
        turned(Vec3.X, axis, sin, cos),
        turned(Vec3.Y, axis, sin, cos),
        turned(Vec3.Z, axis, sin, cos),
        Vec3.ZERO);
  }

  private static Vec3 turned(Vec3 v, Vec3 axis, double sin, double cos) {
    return v.times(cos).plus(sin, axis.cross(v)).plus(axis.dot(v) * (1 - cos), axis);
  }

  /** Returns the place of a camera at a point that looks at another one. */
  private static Transform lookAt(double... v) {
    Vec3 eye = vector(v, 0);
    Vec3 back = eye.minus(vector(v, 3)).normalized();
    Vec3 right = vector(v, 6).cross(back).normalized();
    return Transform.ofAxes(right, back.cross(right), back, eye);
  }

  /**
   * Returns the shear that turns one axis by an angle towards another one, along which all points
   * move (RenderMan Interface 3.2, {@code RiSkew}).
   */
  private static Transform skew(double... v) {
    Vec3 turned = vector(v, 1).normalized();
    Vec3 along = vector(v, 4).normalized();
    double cos = turned.dot(along);
    Vec3 across = turned.plus(-cos, along);
    double sin = across.length();
    Vec3 unit = across.normalized();
    double sinAngle = Elementary.sinDegrees(v[0]);
    double cosAngle = Elementary.cosDegrees(v[0]);
    // The cotangent of the angle between the axes, after and before.
    double after = (cos * cosAngle + sin * sinAngle) / (sin * cosAngle - cos * sinAngle);
    double slope = after - cos / sin;
    return Transform.ofAxes(
        Vec3.X.plus(slope * unit.x(), along),
        Vec3.Y.plus(slope * unit.y(), along),
        Vec3.Z.plus(slope * unit.z(), along),
        Vec3.ZERO);
  }

  private Optional<Transform> valid(Transform transform, DaeElement element) {
    boolean isValid = transform.isInvertible();
    if (!isValid) {
      document
          .file()
          .warnings()
          .add(
              "transforms without a meaning",
              element.location(),
              "expected axes that differ in <%s>, found others; it is ignored"
                  .formatted(element.name()));
    }
    return Optional.of(transform).filter(t -> isValid);
  }
}
