package io.github.lumbre.math;

/** A point or a direction in three dimensions; variable names state its space. Immutable. */
public record Vec3(double x, double y, double z) {
  /** The origin, or the vector without length. */
  public static final Vec3 ZERO = new Vec3(0, 0, 0);

  /** The unit vector along +x. */
  public static final Vec3 X = new Vec3(1, 0, 0);

  /** The unit vector along +y. */
  public static final Vec3 Y = new Vec3(0, 1, 0);

  /** The unit vector along +z. */
  public static final Vec3 Z = new Vec3(0, 0, 1);

  /** Squared lengths outside this range may have lost digits to underflow or overflow. */
  private static final double SMALLEST_SAFE_SQUARE = 0x1p-900;

  private static final double LARGEST_SAFE_SQUARE = 0x1p1000;

  /** Returns the sum. */
  public Vec3 plus(Vec3 o) {
    return new Vec3(x + o.x, y + o.y, z + o.z);
  }

  /** Returns this + s·o. */
  public Vec3 plus(double s, Vec3 o) {
    return new Vec3(x + s * o.x, y + s * o.y, z + s * o.z);
  }

  /** Returns the difference this − o. */
  public Vec3 minus(Vec3 o) {
    return new Vec3(x - o.x, y - o.y, z - o.z);
  }

  /** Returns the product with a number. */
  public Vec3 times(double s) {
    return new Vec3(x * s, y * s, z * s);
  }

  /** Returns the opposite vector. */
  public Vec3 negated() {
    return new Vec3(-x, -y, -z);
  }

  /** Returns the scalar product. */
  public double dot(Vec3 o) {
    return x * o.x + y * o.y + z * o.z;
  }

  /** Returns the cross product; in left-handed space its direction follows the left-hand rule. */
  public Vec3 cross(Vec3 o) {
    return new Vec3(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
  }

  /** Returns the square of the length; it may overflow or underflow, unlike {@link #length}. */
  public double lengthSquared() {
    return x * x + y * y + z * z;
  }

  /** Returns the Euclidean length. */
  public double length() {
    double square = lengthSquared();
    if (square >= SMALLEST_SAFE_SQUARE && square <= LARGEST_SAFE_SQUARE) {
      return Math.sqrt(square);
    }
    double largest = maxAbs();
    if (largest == 0 || !Double.isFinite(largest)) {
      return largest;
    }
    int exponent = Math.getExponent(largest);
    return Math.scalb(Math.sqrt(scaled(exponent).lengthSquared()), exponent);
  }

  /**
   * Returns the unit vector in the same direction, for any finite vector except zero, even if its
   * squared length overflows or underflows. For the zero vector, all components are NaN.
   */
  public Vec3 normalized() {
    // Single allocation site, so that escape analysis can remove it.
    double scaledX = x;
    double scaledY = y;
    double scaledZ = z;
    double square = lengthSquared();
    if (!(square >= SMALLEST_SAFE_SQUARE && square <= LARGEST_SAFE_SQUARE)) {
      Vec3 scaled = scaled(Math.getExponent(maxAbs()));
      scaledX = scaled.x;
      scaledY = scaled.y;
      scaledZ = scaled.z;
      square = scaled.lengthSquared();
    }
    double factor = 1 / Math.sqrt(square);
    return new Vec3(scaledX * factor, scaledY * factor, scaledZ * factor);
  }

  /** Returns this vector divided by 2^exponent, in two steps, so that no factor overflows. */
  private Vec3 scaled(int exponent) {
    double half = Math.scalb(1.0, -(exponent / 2));
    double rest = Math.scalb(1.0, -(exponent - exponent / 2));
    return times(half).times(rest);
  }

  /** Returns the largest absolute coordinate. */
  public double maxAbs() {
    return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
  }

  /** Returns the coordinate of an axis: 0 is x, 1 is y, 2 is z. */
  public double get(int axis) {
    return axis == 0 ? x : axis == 1 ? y : z;
  }

  /** Returns whether all coordinates are finite. */
  public boolean isFinite() {
    return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }
}
