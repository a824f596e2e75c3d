package io.github.lumbre.geometry;

/**
 * A ray in the form that the triangle test uses. Its axes are permuted so that the direction is
 * longest along the last one, which is sheared onto the ray. Mutable.
 */
class ShearedRay {
  /** The permuted axes: kz is the one along which the direction is longest. */
  int kx;

  int ky;
  int kz;

  /** The origin along the permuted axes. */
  double ox;

  double oy;
  double oz;

  /**
   * The direction along kx and along ky, each divided by the direction along kz; and the reciprocal
   * of the direction along kz.
   */
  double sx;

  double sy;
  double sz;

  /** The origin and the direction, indexed by axis so that the permutation needs no branch. */
  private final double[] axes = new double[6];

  /**
   * Sets the ray for the next {@link #shear}: its origin, and its direction of any length except 0.
   */
  final void take(double x, double y, double z, double dx, double dy, double dz) {
    axes[0] = x;
    axes[1] = y;
    axes[2] = z;
    axes[3] = dx;
    axes[4] = dy;
    axes[5] = dz;
  }

  /** Computes the permuted and sheared form of the ray. */
  final void shear() {
    double[] a = axes;
    int k2 = Axes.longest(a[3], a[4], a[5]);
    int k0 = Axes.next(k2);
    int k1 = Axes.next(k0);
    double dz = a[3 + k2];
    kx = k0;
    ky = k1;
    kz = k2;
    ox = a[k0];
    oy = a[k1];
    oz = a[k2];
    sx = a[3 + k0] / dz;
    sy = a[3 + k1] / dz;
    sz = 1 / dz;
  }
}
