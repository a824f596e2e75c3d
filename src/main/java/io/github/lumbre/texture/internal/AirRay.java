package io.github.lumbre.texture.internal;

import io.github.lumbre.math.internal.Elementary;
import java.util.Arrays;

/**
 * A ray through the air, cut into steps that are short at its start: at the middle of each step the
 * scattering matter, the matter before it, and the way of the sun's light to it. Mutable, reused.
 */
final class AirRay {
  private final Air air;
  final int steps;

  /** Scattering and absorbing matter in each step. */
  final double[][] inside;

  /** The amounts from the start of the ray to the middle of each step. */
  final double[][] before;

  /** The amounts from the middle of each step to the sun. */
  final double[][] toSun;

  /** The visible part of the sun at the middle of each step. */
  final double[] sun;

  /** The height of the middle of each step. */
  final double[] height;

  /** The cosine between the vertical and the direction to the sun, at the middle of each step. */
  final double[] sunUp;

  /** The amounts along the whole ray. */
  final double[] whole = new double[Air.COUNT];

  /** The cosine between the vertical and the direction to the sun, at the end of the ray. */
  double sunUpAtEnd;

  /** Whether the ray ends on the ground. */
  boolean isOnGround;

  private final double[] density = new double[Air.COUNT];

  AirRay(Air air, int steps) {
    this.air = air;
    this.steps = steps;
    inside = new double[steps][Air.COUNT];
    before = new double[steps][Air.COUNT];
    toSun = new double[steps][Air.COUNT];
    sun = new double[steps];
    height = new double[steps];
    sunUp = new double[steps];
  }

  /**
   * Sets the ray.
   *
   * @param start height of its start
   * @param up cosine between the ray and the vertical there
   * @param towards cosine of the horizontal angle between the ray and the sun
   * @param sunUpAtStart cosine between the vertical and the direction to the sun there
   */
  void trace(double start, double up, double towards, double sunUpAtStart) {
    double radius = Air.EARTH_RADIUS + start;
    double length = length(radius, up);
    double aside = Elementary.safeSqrt(1 - up * up);
    double sunAside = Elementary.safeSqrt(1 - sunUpAtStart * sunUpAtStart);
    double alongRay = up * sunUpAtStart + aside * sunAside * towards;
    Arrays.fill(whole, 0);
    for (int i = 0; i < steps; i++) {
      double t = (i + .5) / steps;
      double s = length * t * t;
      double here = Math.sqrt(radius * radius + s * (2 * radius * up + s));
      height[i] = Math.min(Air.TOP, Math.max(0, here - Air.EARTH_RADIUS));
      sunUp[i] = (radius * sunUpAtStart + s * alongRay) / here;
      sun[i] = Air.visibleSun(height[i], sunUp[i]);
      air.along(height[i], sunUp[i], toSun[i]);
      add(i, length * 2 * t / steps);
    }
    double end = Math.sqrt(radius * radius + length * (2 * radius * up + length));
    sunUpAtEnd = (radius * sunUpAtStart + length * alongRay) / end;
  }

  private void add(int step, double width) {
    Air.density(height[step], density);
    for (int i = 0; i < Air.COUNT; i++) {
      inside[step][i] = density[i] * width;
      before[step][i] = whole[i] + inside[step][i] / 2;
      whole[i] += inside[step][i];
    }
  }

  private double length(double radius, double up) {
    double across = radius * radius * (1 - up * up);
    double toGround = Air.EARTH_RADIUS * Air.EARTH_RADIUS - across;
    isOnGround = up < 0 && toGround > 0;
    double top = Air.EARTH_RADIUS + Air.TOP;
    return isOnGround
        ? Math.max(0, -radius * up - Math.sqrt(toGround))
        : Elementary.safeSqrt(top * top - across) - radius * up;
  }
}
