package io.github.lumbre.geometry;

/**
 * A ray as the floats of a {@link WideTree} are compared with it: in the tree's space, where t is
 * measured along the longest axis of the direction. Mutable scratch memory, aimed anew for every
 * search.
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

  /** A t beyond all; its depth times the size of a triangle is finite. */
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

  /** The origin in the tree's space, along the axes of {@link ShearedRay}. */
  float x;

  float y;
  float z;

  /** What edge functions may be wrong by: relative to the triangle's size, and at least. */
  float tolerance;

  float floor;

  /** The sign bit of the direction along kz, and how far t = 1 reaches along it. */
  int depthSign;

  float depth;

  /** What depths may be wrong by: absolutely, and in units of what edge functions may be. */
  float depthSlack;

  float depthRoom;

  /** The bits of a t beyond which nothing is looked for any more, and its depth. */
  int last;

  float lastDepth;

  /** What coordinates of boxes and of the origin may be wrong by. */
  private float slack;

  /** The space for all rays from inside of which the errors are set; null if they are others. */
  private UnitSpace inside;

  /** A t's way to the tree's space. */
  private double tScale;

  private double tOffset;

  /** The origin in the tree's space, to be chosen from by an axis' number without a branch. */
  private final double[] axes = new double[3];

  /**
   * Takes a ray.
   *
   * @param hasTriangles whether it is to be compared with triangles, not with boxes alone
   * @return whether it can meet anything
   */
  boolean aim(
      UnitSpace space,
      boolean hasTriangles,
      double ox,
      double oy,
      double oz,
      double dx,
      double dy,
      double dz) {
    double px = (ox - space.centreX) * space.scale;
    double py = (oy - space.centreY) * space.scale;
    double pz = (oz - space.centreZ) * space.scale;
    double longest = Axes.largest(dx, dy, dz);
    double reach = Axes.largest(px, py, pz);
    if (reach <= UnitSpace.INSIDE && longest >= SHORT && longest <= LONG && space.isInReach) {
      // As nearly all rays: what floats may be wrong by is the same for all of them.
      if (inside != space) {
        setErrors(UnitSpace.INSIDE, space.worldReach);
        tScale = space.scale * GROWTH;
        tOffset = 0;
        inside = space;
      }
      depth = (float) longest * GROWTH;
      setSlabs(px, py, pz, atLeast(dx), atLeast(dy), atLeast(dz));
      if (hasTriangles) {
        shear(ox, oy, oz, dx, dy, dz, px, py, pz);
      }
      return true;
    }
    return aimFromAnywhere(space, hasTriangles, ox, oy, oz, dx, dy, dz);
  }

  /** Takes a ray of any length from anywhere, as {@link #aim} does. */
  private boolean aimFromAnywhere(
      UnitSpace space,
      boolean hasTriangles,
      double ox,
      double oy,
      double oz,
      double dx,
      double dy,
      double dz) {
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
    double ux = atLeast(dx * unit);
    double uy = atLeast(dy * unit);
    double uz = atLeast(dz * unit);
    double reach = Axes.largest(px, py, pz);
    double worldReach = Axes.largest(ox, oy, oz) * space.scale + space.centreReach;
    double start = 0;
    boolean isOfLength = unit <= MAX_UNIT && perUnit <= MAX_UNIT;
    if (reach > NEAR && isOfLength) {
      start = entry(px, py, pz, ux, uy, uz, 2 + 0x1p-46 * worldReach);
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
    depth = (float) (longest * unit) * GROWTH;
    if (!(worldReach <= UnitSpace.REACH && isOfLength)) {
      lookAtAll();
      px = 0;
      py = 0;
      pz = 0;
      ux = 1;
      uy = 1;
      uz = 1;
    }
    setSlabs(px, py, pz, ux, uy, uz);
    widenSlabs();
    if (hasTriangles) {
      shear(ox, oy, oz, dx, dy, dz, px, py, pz);
    }
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
    slack = (float) UnitSpace.slack(reach, worldReach);
    tolerance = (float) (0x1p-17 * size);
    floor = (float) (0x1p-37 * size * size);
    depthSlack = 4 * slack;
    depthRoom = (float) (8 * size);
  }

  /** Takes a ray that is out of the reach of floats: a slack makes up for all. */
  private void lookAtAll() {
    tScale = Double.POSITIVE_INFINITY;
    tOffset = 0;
    tolerance = 0;
    floor = Float.POSITIVE_INFINITY;
    depth = 1;
    slack = 0x1p60f;
  }

  /** Takes the ray for boxes that are widened by what it may be wrong by. */
  private void setSlabs(double px, double py, double pz, double ux, double uy, double uz) {
    signX = -Axes.sign(ux);
    signY = -Axes.sign(uy);
    signZ = -Axes.sign(uz);
    ix = 1 / (float) ux;
    iy = 1 / (float) uy;
    iz = 1 / (float) uz;
    inX = -ix * (float) px;
    inY = -iy * (float) py;
    inZ = -iz * (float) pz;
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

  /** Takes the ray for triangles, in the world and in the tree's space. */
  private void shear(
      double wx,
      double wy,
      double wz,
      double dx,
      double dy,
      double dz,
      double px,
      double py,
      double pz) {
    shear(wx, wy, wz, dx, dy, dz);
    axes[0] = px;
    axes[1] = py;
    axes[2] = pz;
    x = (float) axes[kx];
    y = (float) axes[ky];
    z = (float) axes[kz];
    depthSign = Axes.sign(sz) << 31;
  }

  /** Looks no farther than for hits at a t; one that rounding has moved is not missed. */
  void endAt(double t) {
    double end = Math.fma(t, tScale, tOffset);
    float nearer = end < FAR ? (float) end : FAR;
    last = Float.floatToRawIntBits(nearer);
    lastDepth = nearer * depth + depthSlack;
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
