package io.github.lumbre.geometry;

/**
 * A ray as the floats of a {@link WideTree} are compared with it, in the tree's space. Mutable
 * scratch memory, aimed anew for every search.
 *
 * <p>The bounds of all errors are derived in docs/design.md.
 */
final class WideRay extends ShearedRay {
  /** Makes up for the rounding of a t. */
  private static final float GROWTH = 1 + 0x1p-20f;

  /** The least component of a direction. */
  private static final double LEAST = 0x1p-60;

  /** Beyond this distance an origin is moved nearer. */
  private static final double NEAR = 4;

  /** A t beyond all; times the determinant of a triangle it is finite. */
  private static final float FAR = 0x1p100f;

  /** The lengths of directions that floats take as they are, as most are. */
  private static final double SHORT = 0x1p-10;

  private static final double LONG = 0x1p10;

  /** What other directions are at most multiplied or divided by; beyond, all is looked at. */
  private static final double MAX_UNIT = 0x1p960;

  /** All bits set for an axis along which the direction is negative, otherwise none. */
  int signX;

  int signY;
  int signZ;

  /** What a coordinate of a box is multiplied by, for its t. */
  float ix;

  float iy;
  float iz;

  /** What is then added for the near sides. */
  float inX;

  float inY;
  float inZ;

  /** What is added for the far sides. */
  float outX;

  float outY;
  float outZ;

  /** The origin and the direction in the tree's space, for triangles. */
  float x;

  float y;
  float z;
  float dx;
  float dy;
  float dz;

  /** What edge functions may be wrong by: in units of the triangle's spread, and besides. */
  float edgeError;

  float edgeFloor;

  /** What t times the determinant may be wrong by: in units of the spread's square, and besides. */
  float depthError;

  float depthFloor;

  /** The t beyond which nothing is looked for any more, and its bits. */
  float end;

  int last;

  /** What coordinates of boxes and of the origin may be wrong by. */
  private float slack;

  /** What edge functions may be wrong by for a direction of length 1. */
  private float edgeErrorOfUnit;

  private float edgeFloorOfUnit;

  /** The space for all rays from inside of which the errors are set; null if they are others. */
  private UnitSpace inside;

  /** A t's way to the tree's space. */
  private double tScale;

  private double tOffset;

  /** Takes a ray; tells whether it can meet anything. */
  boolean aim(UnitSpace space, double ox, double oy, double oz, double dx, double dy, double dz) {
    take(ox, oy, oz, dx, dy, dz);
    double px = (ox - space.centreX) * space.scale;
    double py = (oy - space.centreY) * space.scale;
    double pz = (oz - space.centreZ) * space.scale;
    double length = Axes.sum(dx, dy, dz);
    if (length >= SHORT && length <= LONG && space.isInside(px, py, pz)) {
      // As nearly all rays: what floats may be wrong by is the same for all of them.
      if (inside != space) {
        setErrors(UnitSpace.INSIDE, space.worldReach);
        tScale = space.scale * GROWTH;
        tOffset = 0;
        inside = space;
      }
      setFloats(px, py, pz, dx, dy, dz);
      return true;
    }
    return aimFromAnywhere(space, ox, oy, oz, dx, dy, dz);
  }

  /** Takes a ray of any length from anywhere, as {@link #aim} does. */
  private boolean aimFromAnywhere(
      UnitSpace space, double ox, double oy, double oz, double dx, double dy, double dz) {
    inside = null;
    double px = (ox - space.centreX) * space.scale;
    double py = (oy - space.centreY) * space.scale;
    double pz = (oz - space.centreZ) * space.scale;
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
    double worldReach = Axes.largest(ox, oy, oz) * space.scale + space.centreReach;
    double start = 0;
    boolean isOfLength = unit <= MAX_UNIT && perUnit <= MAX_UNIT;
    if (reach > NEAR && isOfLength) {
      double room = 2 + 0x1p-46 * worldReach;
      start = entry(px, py, pz, atLeast(ux), atLeast(uy), atLeast(uz), room);
      if (start < 0) {
        return false;
      }
      px += start * ux;
      py += start * uy;
      pz += start * uz;
      reach = Axes.largest(px, py, pz);
    }
    // A product, since the compiler keeps a number made of bits in a copy for each of its uses.
    tScale = perUnit * space.scale * GROWTH;
    tOffset = start * (0x1p-48 - GROWTH);
    setErrors(reach, worldReach);
    if (!(worldReach <= UnitSpace.REACH && isOfLength)) {
      lookAtAll();
      px = 0;
      py = 0;
      pz = 0;
      ux = 1;
      uy = 1;
      uz = 1;
    }
    setFloats(px, py, pz, ux, uy, uz);
    widenSlabs();
    return true;
  }

  /**
   * Sets what floats may be wrong by.
   *
   * @param reach how far the origin is from the centre of the tree's space, by its largest
   *     coordinate, or a bound of it
   * @param worldReach the largest of the coordinates that the origin was computed from, in units of
   *     that space, or a bound of it
   */
  private void setErrors(double reach, double worldReach) {
    double size = 1 + reach + 0x1p-24 * worldReach;
    double ofDoubles = 0x1p-48 * (1 + reach + worldReach);
    slack = (float) UnitSpace.slack(reach, worldReach);
    edgeErrorOfUnit = (float) (24 * 0x1p-24 * size);
    edgeFloorOfUnit = (float) (ofDoubles * ofDoubles);
    depthError = (float) (72 * 0x1p-24 * size);
    depthFloor = (float) (80 * size * size * ofDoubles);
  }

  /** Takes a ray that is out of the reach of floats: errors without bound make up for all. */
  private void lookAtAll() {
    tScale = Double.POSITIVE_INFINITY;
    tOffset = 0;
    edgeErrorOfUnit = 0;
    edgeFloorOfUnit = Float.POSITIVE_INFINITY;
    depthError = 0;
    depthFloor = Float.POSITIVE_INFINITY;
    slack = 0x1p60f;
  }

  /** Takes the ray for triangles, and for boxes that are widened by what it may be wrong by. */
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
    signX = -Axes.sign(ux);
    signY = -Axes.sign(uy);
    signZ = -Axes.sign(uz);
    ix = 1 / (float) atLeast(ux);
    iy = 1 / (float) atLeast(uy);
    iz = 1 / (float) atLeast(uz);
    inX = -ix * x;
    inY = -iy * y;
    inZ = -iz * z;
    outX = inX;
    outY = inY;
    outZ = inZ;
  }

  /** Widens all boxes by the slack. */
  private void widenSlabs() {
    inX -= slack * Math.abs(ix);
    inY -= slack * Math.abs(iy);
    inZ -= slack * Math.abs(iz);
    outX += slack * Math.abs(ix);
    outY += slack * Math.abs(iy);
    outZ += slack * Math.abs(iz);
  }

  /** Looks no farther than for hits at a t; one that rounding has moved is not missed. */
  void endAt(double t) {
    double nearer = Math.fma(t, tScale, tOffset);
    end = nearer < FAR ? (float) nearer : FAR;
    last = Float.floatToRawIntBits(end);
  }

  /** Returns where a ray from afar enters the space [-room, room]³; negative if it never does. */
  private static double entry(
      double x, double y, double z, double dx, double dy, double dz, double room) {
    double nearX = (-Math.copySign(room, dx) - x) / dx;
    double nearY = (-Math.copySign(room, dy) - y) / dy;
    double nearZ = (-Math.copySign(room, dz) - z) / dz;
    double farX = (Math.copySign(room, dx) - x) / dx;
    double farY = (Math.copySign(room, dy) - y) / dy;
    double farZ = (Math.copySign(room, dz) - z) / dz;
    double near = Math.max(Math.max(nearX, nearY), Math.max(nearZ, 0));
    return near <= Math.min(farX, Math.min(farY, farZ)) ? near : -1;
  }

  /** Returns a power of two; infinity where double precision has none. */
  private static double power(int exponent) {
    return Math.abs(exponent) < 1023
        ? Double.longBitsToDouble(exponent + 1023L << 52)
        : Double.POSITIVE_INFINITY;
  }

  private static double atLeast(double d) {
    return Math.abs(d) < LEAST ? Math.copySign(LEAST, d) : d;
  }
}
