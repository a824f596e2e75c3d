package io.github.lumbre.model.difference;

import io.github.lumbre.base.text.Quantities;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * The axes and the unit of a model's file, in which changes are stated.
 *
 * @param fromFile from the file's axes and unit to the model's world space
 * @param unit of the file, such as {@code millimeter}; empty if it states none
 */
public record FileSpace(Transform fromFile, String unit) {
  static final FileSpace WORLD = new FileSpace(Transform.IDENTITY, "");

  private static final MathContext DIGITS = new MathContext(4);

  Vec3 vector(Vec3 world) {
    return fromFile.inverseVector(world);
  }

  /** Returns a length of the world in the unit of the file. */
  public double length(double world) {
    return world / scale();
  }

  /** Returns a length of the file in the unit of the world. */
  public double inWorld(double length) {
    return length * scale();
  }

  private double scale() {
    return fromFile.vector(Vec3.X).length();
  }

  /** Returns a length with its unit. */
  public String text(double length) {
    return withUnit(number(length));
  }

  /** Returns a vector with its unit, such as (0, -8, 0) mm, in four digits of its length. */
  public String text(Vec3 vector) {
    double length = vector.length();
    int scale = Double.isFinite(length) ? new BigDecimal(length).round(DIGITS).scale() : 0;
    return withUnit(
        "(%s, %s, %s)"
            .formatted(
                rounded(vector.x(), scale),
                rounded(vector.y(), scale),
                rounded(vector.z(), scale)));
  }

  /** Returns a vector in the digits that an error of it leaves; as it is without an error. */
  Vec3 rounded(Vec3 vector, double error) {
    if (!(error > 0) || !vector.isFinite()) {
      return vector;
    }
    BigDecimal digit = new BigDecimal(error).round(new MathContext(1));
    int scale = digit.scale() - digit.precision() + 1;
    return new Vec3(
        rounded(scale, vector.x()), rounded(scale, vector.y()), rounded(scale, vector.z()));
  }

  private static double rounded(int scale, double value) {
    // The sum with 0 replaces -0 by 0.
    return new BigDecimal(value).setScale(scale, RoundingMode.HALF_EVEN).doubleValue() + 0.;
  }

  private static String rounded(double value, int scale) {
    return Double.isFinite(value)
        ? number(new BigDecimal(value).setScale(scale, RoundingMode.HALF_EVEN).doubleValue())
        : number(value);
  }

  private static String number(double value) {
    return Double.isFinite(value) ? Quantities.text(value) : Double.toString(value);
  }

  private String withUnit(String numbers) {
    return unit.isEmpty() ? numbers : numbers + " " + Quantities.symbol(unit);
  }

  /** Returns the sides of the box around vertices, such as 4 x 3 x 1 mm. */
  String size(PartShape part) {
    Bounds3 box = Bounds3.EMPTY;
    for (int i = 0; i < part.vertexCount(); i++) {
      box = box.union(fromFile.inversePoint(part.centroid().plus(part.offset(i))));
    }
    Vec3 size = box.max().minus(box.min());
    return withUnit(number(size.x()) + " x " + number(size.y()) + " x " + number(size.z()));
  }

  /** Returns the area of a part, such as 12.57 mm². */
  String area(PartShape part) {
    String area = withUnit(number(part.area() / scale() / scale()));
    return unit.isEmpty() ? area : area + "²";
  }
}
