package io.github.lumbre.model.section;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Locale;

/**
 * A plane that cuts a model, as users state it. {@code x=0.5} is a plane across an axis of the
 * file, in the file's unit or in percent of the model's bounds, such as {@code y=50%}. It removes
 * what is in front of it, seen from the right, the top or the front; a sign before the axis names
 * the removed side: {@code -x=0.5} removes smaller x. {@code 0,0,1/1,1,0} is a plane by a point and
 * a normal, which points to the removed side. The case of letters does not matter.
 *
 * @param text of the section
 * @param point in the file's axes; each coordinate is in the file's unit or in percent
 * @param normal in the file's axes, pointing to the removed side; of any length
 * @param facesViewer whether the removed side is in front, whatever the normal's direction
 */
public record Section(String text, List<Coordinate> point, Vec3 normal, boolean facesViewer) {
  /** The texts of sections, for messages. */
  public static final String EXPECTED =
      "a plane such as x=0.5, y=50%, -z=2 or a point and a normal 0,0,1/1,1,0";

  /** A length in the file's unit, or a percentage of the model's bounds. */
  record Coordinate(double value, boolean isPercent) {
    double in(double min, double max) {
      return isPercent ? min + value / 100 * (max - min) : value;
    }
  }

  /**
   * Returns the section in a text.
   *
   * @throws IllegalArgumentException if it is none
   */
  public static Section of(String text) {
    int equals = text.indexOf('=');
    return equals >= 0 ? ofAxis(text, equals) : ofPoint(text);
  }

  private static Section ofAxis(String text, int equals) {
    String axis = text.substring(0, equals);
    boolean isSigned = axis.startsWith("-") || axis.startsWith("+");
    String name = (isSigned ? axis.substring(1) : axis).toLowerCase(Locale.ROOT);
    int number = List.of("x", "y", "z").indexOf(name);
    require(number >= 0, text);
    Coordinate at = coordinate(text, text.substring(equals + 1));
    Coordinate zero = new Coordinate(0, false);
    Vec3 normal = List.of(Vec3.X, Vec3.Y, Vec3.Z).get(number);
    return new Section(
        text,
        List.of(number == 0 ? at : zero, number == 1 ? at : zero, number == 2 ? at : zero),
        axis.startsWith("-") ? normal.negated() : normal,
        !isSigned);
  }

  private static Section ofPoint(String text) {
    String[] both = text.split("/", -1);
    require(both.length == 2, text);
    String[] point = both[0].split(",", -1);
    String[] normal = both[1].split(",", -1);
    require(point.length == 3 && normal.length == 3, text);
    Vec3 direction =
        new Vec3(number(text, normal[0]), number(text, normal[1]), number(text, normal[2]));
    double size = direction.maxAbs();
    require(size > 0, text);
    return new Section(
        text,
        List.of(coordinate(text, point[0]), coordinate(text, point[1]), coordinate(text, point[2])),
        direction.times(1 / size),
        false);
  }

  private static Coordinate coordinate(String text, String part) {
    boolean isPercent = part.endsWith("%");
    String number = isPercent ? part.substring(0, part.length() - 1) : part;
    return new Coordinate(number(text, number), isPercent);
  }

  private static double number(String text, String part) {
    double number = Double.NaN;
    try {
      number = Double.parseDouble(part);
    } catch (NumberFormatException e) {
      require(false, text);
    }
    require(Double.isFinite(number), text);
    return number;
  }

  /** Returns whether a text is a section. */
  public static boolean isValid(String text) {
    try {
      of(text);
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  private static void require(boolean condition, String text) {
    if (!condition) {
      throw new IllegalArgumentException("expected " + EXPECTED + ", found " + text);
    }
  }

  /**
   * Returns the plane in the model's world space.
   *
   * @param bounds of the model in the file's axes and unit
   * @param toWorld from the file's axes and unit
   */
  CutPlane in(Bounds3 bounds, Transform toWorld) {
    Vec3 place =
        new Vec3(
            point.get(0).in(bounds.min().x(), bounds.max().x()),
            point.get(1).in(bounds.min().y(), bounds.max().y()),
            point.get(2).in(bounds.min().z(), bounds.max().z()));
    Vec3 outward = toWorld.normal(normal);
    // Viewers from the right, the top and the front are at greater x, y and z.
    boolean isBehind = outward.x() + outward.y() + outward.z() < 0;
    return CutPlane.of(toWorld.point(place), facesViewer && isBehind ? outward.negated() : outward);
  }
}
