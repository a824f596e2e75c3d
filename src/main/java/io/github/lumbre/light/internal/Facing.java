package io.github.lumbre.light.internal;

import io.github.lumbre.light.Light;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;

/**
 * A quick test for points that an emitter cannot light, because it lies wholly behind the surface
 * there, or because the point lies behind the emitter. It saves the samples that would turn out
 * black. Immutable.
 */
public final class Facing {
  /**
   * Tolerance for rounding, relative to the coordinates. It also exceeds the rounding of the
   * bounds.
   */
  private static final double ROUNDING = 1e-8;

  /** The center and the half sides of the emitter's bounding box; NaN if it has none. */
  private final double x, y, z;

  private final double halfX, halfY, halfZ;

  /** The direction that a flat emitter faces; zero for all others. */
  private final double axisX, axisY, axisZ;

  /** The extent of the box along the axis, to either side of the center. */
  private final double thickness;

  /** The sum of the box's absolute coordinates: a bound of them. */
  private final double size;

  private Facing(Bounds3 box, Vec3 axis) {
    Vec3 center = box.center();
    Vec3 half = box.max().minus(center);
    x = center.x();
    y = center.y();
    z = center.z();
    halfX = half.x();
    halfY = half.y();
    halfZ = half.z();
    axisX = axis.x();
    axisY = axis.y();
    axisZ = axis.z();
    thickness = extent(axisX, axisY, axisZ);
    size = Math.abs(x) + Math.abs(y) + Math.abs(z) + halfX + halfY + halfZ;
  }

  /** Returns the test for an emitter; one that reaches the whole scene never faces away. */
  public static Facing of(Light emitter) {
    return emitter
        .bounds()
        .map(bounds -> new Facing(bounds.box(), bounds.isFlat() ? bounds.axis() : Vec3.ZERO))
        .orElseGet(() -> new Facing(Bounds3.EMPTY, Vec3.ZERO));
  }

  /** Returns the box's extent along a direction, to either side of its center. */
  private double extent(double dx, double dy, double dz) {
    return Math.abs(dx) * halfX + Math.abs(dy) * halfY + Math.abs(dz) * halfZ;
  }

  /**
   * Returns whether the emitter is known not to light a point. All its samples are then empty, or
   * black because they come from behind the surface.
   */
  public boolean isAway(LightChoice receiver) {
    double dx = x - receiver.x;
    double dy = y - receiver.y;
    double dz = z - receiver.z;
    double margin =
        ROUNDING * (size + Math.abs(receiver.x) + Math.abs(receiver.y) + Math.abs(receiver.z));
    double nx = receiver.normalX;
    double ny = receiver.normalY;
    double nz = receiver.normalZ;
    // Both false for NaN, which boxes have that are empty or infinite.
    return dx * nx + dy * ny + dz * nz + extent(nx, ny, nz) < -margin
        || thickness - (dx * axisX + dy * axisY + dz * axisZ) < -margin;
  }
}
