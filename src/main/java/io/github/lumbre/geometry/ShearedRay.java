package io.github.lumbre.geometry;

/**
 * A ray as triangles are tested with it: its axes in another order, the last one the one along
 * which the direction is longest, sheared onto the ray. Mutable scratch memory.
 */
class ShearedRay {
  /** The axis along which the direction is longest, and before it the two that are sheared. */
  int kx;

  int ky;
  int kz;

  /** The origin along these axes. */
  double ox;

  double oy;
  double oz;

  /** Direction along kx, and ky, over that along kz; and the reciprocal of that along kz. */
  double sx;

  double sy;
  double sz;

  /** Origin and direction, to be chosen from by an axis' number without a branch. */
  private final double[] axes = new double[6];

  /** Takes a ray, to be sheared: its origin, and its direction, of any length but not zero. */
  final void take(double x, double y, double z, double dx, double dy, double dz) {
    axes[0] = x;
    axes[1] = y;
    axes[2] = z;
    axes[3] = dx;
    axes[4] = dy;
    axes[5] = dz;
  }

  /** Shears the ray that was taken last. */
  final void shear() {
    kz = Axes.longest(axes[3], axes[4], axes[5]);
    kx = Axes.next(kz);
    ky = Axes.next(kx);
    ox = axes[kx];
    oy = axes[ky];
    oz = axes[kz];
    sx = axes[3 + kx] / axes[3 + kz];
    sy = axes[3 + ky] / axes[3 + kz];
    sz = 1 / axes[3 + kz];
  }
}
