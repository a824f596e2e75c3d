package io.github.lumbre.material.internal;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.internal.Warp;

/**
 * The Trowbridge–Reitz (GGX) distribution, which has long tails (Walter et al. 2007, sec. 5.2).
 *
 * @param alpha roughness, &gt; 0
 */
public record Ggx(double alpha) implements Microfacets {
  @Override
  public double density(Vec3 m) {
    // cos⁴ (1 + tan²/α²)², rewritten so that neither a small cosine nor a small α loses digits.
    double sin2 = m.x() * m.x() + m.y() * m.y();
    double root = alpha * m.z() * m.z() + sin2 / alpha;
    return m.z() <= 0 ? 0 : Elementary.INV_PI / (root * root);
  }

  /** Returns Λ(θ) · cos θ with Λ = (√(1 + α² tan² θ) − 1) / 2 (Heitz 2014, eq. 72). */
  @Override
  public double hidden(double cosTheta) {
    double cos2 = cosTheta * cosTheta;
    return .5 * (Math.sqrt(cos2 + alpha * alpha * (1 - cos2)) - cosTheta);
  }

  /**
   * {@inheritDoc}
   *
   * <p>Heitz 2018, "Sampling the GGX Distribution of Visible Normals".
   */
  @Override
  public Vec3 sampleVisible(Vec3 wo, Point2 u) {
    Vec3 v = new Vec3(alpha * wo.x(), alpha * wo.y(), wo.z()).normalized();
    double across = Math.sqrt(v.x() * v.x() + v.y() * v.y());
    boolean isSlanted = across > 0;
    Vec3 t1 = new Vec3(isSlanted ? -v.y() / across : 1, isSlanted ? v.x() / across : 0, 0);
    Vec3 t2 = v.cross(t1);
    Point2 p = Warp.concentricDisk(u);
    double s = .5 * (1 + v.z());
    double y = (1 - s) * Elementary.safeSqrt(1 - p.x() * p.x()) + s * p.y();
    double z = Elementary.safeSqrt(1 - p.x() * p.x() - y * y);
    Vec3 n = t1.times(p.x()).plus(y, t2).plus(z, v);
    return new Vec3(alpha * n.x(), alpha * n.y(), Math.max(1e-300, n.z())).normalized();
  }
}
