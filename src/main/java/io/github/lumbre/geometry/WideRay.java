package io.github.lumbre.geometry;

import io.github.lumbre.math.internal.FusedMultiplyAdd;

/**
 * A ray in the space of a {@link WideTree}, as floats for its box and triangle tests. Mutable; each
 * traversal sets it again.
 *
 * <p>All error bounds are derived in docs/design.md.
 */
final class WideRay extends ShearedRay {
  /** The factor that compensates for the rounding of t. */
  private static final float GROWTH = 1 + 0x1p-20f;

  /** The factor that compensates for {@link #GROWTH} and for the rounding of t. */
  private static final double SHRINKING = 1 - 0x1p-18;

  /** The smallest absolute value of a direction component; smaller ones are raised to it. */
  private static final double LEAST = 0x1p-60;

  /** A t beyond all hits; its product with the determinant of a triangle is finite. */
  private static final float FAR = 0x1p100f;

  /** The range of direction lengths that need no scaling. */
  private static final double SHORT = 0x1p-10;

  private static final double LONG = 0x1p10;

  /** The largest factor that scales other directions; beyond it, all items are candidates. */
  private static final double MAX_UNIT = 0x1p960;

  /** The factor of a box coordinate in its t. */
  float ix;

  float iy;
  float iz;

  /** The summand of a box coordinate's t. */
  float shiftX;

  float shiftY;
  float shiftZ;

  /** The origin and the direction in the tree's space, for triangle tests. */
  float x;

  float y;
  float z;
  float dx;
  float dy;
  float dz;

  /** Error bounds of the edge functions: per unit of the triangle's spread, and absolute. */
  float edgeError;

  float edgeFloor;

  /** Error bounds of t times the determinant: per unit of the squared spread, and absolute. */
  float depthError;

  float depthFloor;

  /** The t beyond which hits are ignored, and its bits. */
  float end;

  int last;

  /** The bits of the t before which boxes are ignored that the ray has left. */
  int first;

  /** Error bounds of the edge functions for a direction of length 1. */
  private float edgeErrorOfUnit;

  private float edgeFloorOfUnit;

  /** The space whose errors for near origins are currently set; null if other errors are set. */
  private UnitSpace near;

  /** The factor and the summand that map t to the tree's space. */
  private double tScale;

  private double tOffset;

  /** Sets the ray; returns whether it can hit any box. */
  boolean aim(UnitSpace space, double ox, double oy, double oz, double dx, double dy, double dz) {
    take(ox, oy, oz, dx, dy, dz);
    double px = (ox - space.centerX) * space.scale;
    double py = (oy - space.centerY) * space.scale;
    double pz = (oz - space.centerZ) * space.scale;
    double length = Axes.sum(dx, dy, dz);
    if (!(length >= SHORT && length <= LONG && space.isNear(px, py, pz))) {
      return aimFromAnywhere(space, ox, oy, oz, dx, dy, dz);
    }
    // The common case: all these rays have the same error bounds.
    if (near != space) {
      setErrors(UnitSpace.INSIDE, space.nearReach);
      tScale = space.scale * GROWTH;
      near = space;
    }
    if (UnitSpace.isInside(px, py, pz)) {
      tOffset = 0;
      setFloats(px, py, pz, dx, dy, dz);
      return true;
    }
    double start = entry(px, py, pz, dx, dy, dz, space.nearReach);
    tOffset = offset(start);
    setFloats(px + start * dx, py + start * dy, pz + start * dz, dx, dy, dz);
    return start >= 0;
  }

  /** Sets a ray with any origin and any length, as {@link #aim} does. */
  private boolean aimFromAnywhere(
      UnitSpace space, double ox, double oy, double oz, double dx, double dy, double dz) {
    near = null;
    double px = (ox - space.centerX) * space.scale;
    double py = (oy - space.centerY) * space.scale;
    double pz = (oz - space.centerZ) * space.scale;
    double longest = Axes.largest(dx, dy, dz);
    double unit = 1;
    double perUnit = 1;
    if (!(longest >= SHORT && longest <= LONG)) {
      unit = power(-Math.getExponent(longest));
      perUnit = power(Math.getExponent(longest));
    }
    double ux = dx * unit;
    double uy = dy * unit;
    double uz = dz * unit;
    double reach = Axes.largest(px, py, pz);
    double worldReach = Axes.largest(ox, oy, oz) * space.scale + space.centerReach;
    double start = 0;
    boolean isOfLength = unit <= MAX_UNIT && perUnit <= MAX_UNIT;
    if (reach > UnitSpace.INSIDE && isOfLength) {
      start = entry(px, py, pz, ux, uy, uz, worldReach);
      if (start < 0) {
        return false;
      }
      px += start * ux;
      py += start * uy;
      pz += start * uz;
      reach = Axes.largest(px, py, pz);
    }
    // A product, because the JIT would keep one copy of a number made from bits for each use.
    tScale = perUnit * space.scale * GROWTH;
    tOffset = offset(start);
    if (reach <= UnitSpace.INSIDE && worldReach <= space.coveredReach && isOfLength) {
      setErrors(reach, worldReach);
      setFloats(px, py, pz, ux, uy, uz);
    } else {
      lookAtAll();
    }
    return true;
  }

  /**
   * Sets the error bounds.
   *
   * @param reach the largest absolute coordinate of the origin in the tree's space, or a bound of
   *     it
   * @param worldReach the largest absolute world coordinate of the origin and the center, in units
   *     of the tree's space, or a bound of it
   */
  private void setErrors(double reach, double worldReach) {
    double size = 1 + reach + 0x1p-24 * worldReach;
    double ofDoubles = 0x1p-48 * (1 + reach + worldReach);
    edgeErrorOfUnit = (float) (28 * 0x1p-24 * size);
    edgeFloorOfUnit = (float) (ofDoubles * ofDoubles);
    depthError = (float) (104 * 0x1p-24 * size);
    depthFloor = (float) (80 * size * size * ofDoubles);
  }

  /**
   * Handles a ray that is out of the reach of floats: all boxes have the same t, and with unlimited
   * errors, all items are candidates.
   */
  private void lookAtAll() {
    tScale = Double.POSITIVE_INFINITY;
    tOffset = 0;
    edgeErrorOfUnit = 0;
    edgeFloorOfUnit = Float.POSITIVE_INFINITY;
    depthError = 0;
    depthFloor = Float.POSITIVE_INFINITY;
    setFloats(0, 0, 0, 1, 1, 1);
    // Boxes round to t = 4, and what is no box is beyond FAR.
    ix = 0x1p-25f;
    iy = 0x1p-25f;
    iz = 0x1p-25f;
    shiftX = 4;
    shiftY = 4;
    shiftZ = 4;
  }

  /** Sets the floats for triangles, and for boxes, which include the error margin. */
  private void setFloats(double px, double py, double pz, double ux, double uy, double uz) {
    x = (float) px;
    y = (float) py;
    z = (float) pz;
    dx = (float) ux;
    dy = (float) uy;
    dz = (float) uz;
    float length = (float) Axes.sum(ux, uy, uz);
    edgeError = edgeErrorOfUnit * length;
    edgeFloor = edgeFloorOfUnit * length;
    ix = 1 / (float) atLeast(ux);
    iy = 1 / (float) atLeast(uy);
    iz = 1 / (float) atLeast(uz);
    shiftX = -ix * x;
    shiftY = -iy * y;
    shiftZ = -iz * z;
  }

  /** Sets the end of the ray to t, with a margin that covers rounding errors. */
  void endAt(double t) {
    double nearer = FusedMultiplyAdd.of(t, tScale, tOffset);
    end = nearer < FAR ? (float) nearer : FAR;
    last = Float.floatToRawIntBits(end);
  }

  /**
   * Sets the hit behind which the search begins to t, with a margin that covers rounding errors.
   *
   * @param t at least 0
   */
  void beginAt(double t) {
    double later = Math.fma(t, tScale, tOffset);
    double sooner = later * SHRINKING + tOffset * 0x1p-46;
    first = sooner > 0 && later < FAR ? Float.floatToRawIntBits((float) sooner) : 0;
  }

  /** Returns the summand of t for a ray that is moved by some t. */
  private static double offset(double start) {
    return start * (0x1p-48 - GROWTH);
  }

  /**
   * Returns the t at which a ray from outside enters a cube that contains all boxes with their
   * margins; negative if it misses the cube.
   *
   * @param worldReach see {@link #setErrors}
   */
  private static double entry(
      double x, double y, double z, double ux, double uy, double uz, double worldReach) {
    double room = 1 + 0x1p-5 + 0x1p-46 * worldReach;
    double dx = atLeast(ux);
    double dy = atLeast(uy);
    double dz = atLeast(uz);
    double perX = 1 / dx;
    double perY = 1 / dy;
    double perZ = 1 / dz;
    double nearX = (-Math.copySign(room, dx) - x) * perX;
    double nearY = (-Math.copySign(room, dy) - y) * perY;
    double nearZ = (-Math.copySign(room, dz) - z) * perZ;
    double farX = (Math.copySign(room, dx) - x) * perX;
    double farY = (Math.copySign(room, dy) - y) * perY;
    double farZ = (Math.copySign(room, dz) - z) * perZ;
    double near = Math.max(Math.max(nearX, nearY), Math.max(nearZ, 0));
    return near <= Math.min(farX, Math.min(farY, farZ)) ? near : -1;
  }

  /** Returns a power of two; infinity outside the range of normal doubles. */
  private static double power(int exponent) {
    return Math.abs(exponent) < 1023
        ? Double.longBitsToDouble(exponent + 1023L << 52)
        : Double.POSITIVE_INFINITY;
  }

  private static double atLeast(double d) {
    return Math.abs(d) < LEAST ? Math.copySign(LEAST, d) : d;
  }
}
