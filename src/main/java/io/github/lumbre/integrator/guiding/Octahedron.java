package io.github.lumbre.integrator.guiding;

/**
 * The octahedral map between unit directions and the unit square (Praun and Hoppe 2003; Cigolle et
 * al. 2014, "Survey of Efficient Representations for Independent Unit Vectors"). It needs neither
 * trigonometric functions nor branches that depend on more than signs. It does not preserve area:
 * {@link #stretch} is the factor between the two densities.
 */
final class Octahedron {
  private Octahedron() {}

  /** Returns the first coordinate in the unit square of a direction of any length above 0. */
  static double u(double x, double y, double z) {
    double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
    double a = z >= 0 ? x / sum : Math.copySign(1 - Math.abs(y) / sum, x);
    return .5 * a + .5;
  }

  /** Returns the second coordinate in the unit square of a direction of any length above 0. */
  static double v(double x, double y, double z) {
    double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
    double b = z >= 0 ? y / sum : Math.copySign(1 - Math.abs(x) / sum, y);
    return .5 * b + .5;
  }

  /**
   * Returns the density per solid angle of a unit direction for a density of 1 in the unit square.
   *
   * <p>The four faces of half an octahedron map to the square of side 2, and the face x + y + z = 1
   * is seen from the origin under the solid angle dω = da db / |p|³, where |p| = 1 / (|x| + |y| +
   * |z|).
   */
  static double stretch(double x, double y, double z) {
    double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
    return .25 / (sum * sum * sum);
  }

  /** Sets a unit direction from its coordinates in the unit square. */
  static void direction(double u, double v, GuideSample result) {
    double a = 2 * u - 1;
    double b = 2 * v - 1;
    double z = 1 - Math.abs(a) - Math.abs(b);
    if (z < 0) {
      double folded = Math.copySign(1 - Math.abs(b), a);
      b = Math.copySign(1 - Math.abs(a), b);
      a = folded;
    }
    double scale = 1 / Math.sqrt(a * a + b * b + z * z);
    result.setDirection(a * scale, b * scale, z * scale);
  }
}
