package io.github.lumbre.material.internal;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * The Beckmann distribution, in which the slopes of the surface are normally distributed (Walter et
 * al. 2007, sec. 5.2). The 2016 report uses it.
 *
 * @param alpha roughness: √2 times the standard deviation of the slopes, &gt; 0
 */
public record Beckmann(double alpha) implements Microfacets {
  private static final double INV_SQRT_PI = 0.5641895835477563;

  @Override
  public double density(Vec3 m) {
    if (m.z() <= 0) {
      return 0;
    }
    double cos2 = m.z() * m.z();
    double tan2 = (m.x() * m.x() + m.y() * m.y()) / cos2;
    double e = Elementary.exp(-tan2 / (alpha * alpha));
    // Near the horizon the denominator is 0 too.
    return e == 0 ? 0 : e / (Math.PI * alpha * alpha * cos2 * cos2);
  }

  /**
   * Returns Λ(θ) · cos θ with Λ = exp(−a²) / (2a√π) − erfc(a) / 2 and a = 1 / (α tan θ) (Walter et
   * al. 2007, sec. 5.2).
   */
  @Override
  public double hidden(double cosTheta) {
    double steepness = alpha * Elementary.safeSqrt(1 - cosTheta * cosTheta);
    if (cosTheta > VisibleSlope.STEEPEST * steepness) {
      return 0;
    }
    double a = cosTheta / steepness;
    double beyond = INV_SQRT_PI - a * Elementary.erfcScaled(a);
    return .5 * steepness * Elementary.exp(-a * a) * beyond;
  }

  /**
   * Stretches the surface to α = 1, samples the two slopes, and shrinks the surface back (Heitz
   * 2014).
   */
  @Override
  public Vec3 sampleVisible(Vec3 wo, Point2 u) {
    Vec3 v = new Vec3(alpha * wo.x(), alpha * wo.y(), wo.z()).normalized();
    double sin = Math.sqrt(v.x() * v.x() + v.y() * v.y());
    double cosPhi = sin > 0 ? v.x() / sin : 1;
    double sinPhi = sin > 0 ? v.y() / sin : 0;
    double along = VisibleSlope.at(v.z(), sin, u.x());
    double across = VisibleSlope.at(1, 0, u.y());
    double slopeX = cosPhi * along - sinPhi * across;
    double slopeY = sinPhi * along + cosPhi * across;
    return new Vec3(-alpha * slopeX, -alpha * slopeY, 1).normalized();
  }
}
