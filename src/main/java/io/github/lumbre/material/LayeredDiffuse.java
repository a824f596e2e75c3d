package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;

/**
 * Diffuse reflection below a dielectric layer of albedo E: f = albedo / π · (1 - E(o)) (1 - E(i)) /
 * (1 - mean E), which is reciprocal and reflects, together with the layer, at most 1 (Kelemen and
 * Szirmay-Kalos 2001, "A Microfacet Based Coupled Specular-Matte BRDF Model").
 *
 * @param albedo each component in [0,1]
 * @param f0 largest reflectance of the layer at normal incidence
 * @param f90 reflectance of the layer at grazing incidence
 * @param alpha roughness of the layer
 */
record LayeredDiffuse(Rgb albedo, double f0, double f90, double alpha) implements Lobe {
  /** Returns this reflection with its albedo times a color, each component in [0,1]. */
  LayeredDiffuse tinted(Rgb color) {
    return new LayeredDiffuse(albedo.times(color), f0, f90, alpha);
  }

  private double passed(double cosine) {
    return Math.max(0, 1 - GgxAlbedo.of(f0, f90, Math.abs(cosine), alpha));
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    if (!(woZ * wiZ > 0)) {
      result.clear();
      return;
    }
    double pdf = Warp.cosineHemispherePdf(Math.abs(wiZ));
    // A layer that reflects all light leaves nothing.
    double below = 1 - GgxAlbedo.mean(f0, f90, alpha);
    double layer = below > 0 ? passed(woZ) * passed(wiZ) / below : 0;
    result.set(albedo.times(layer * pdf), pdf);
  }

  @Override
  public boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 up = Warp.cosineHemisphere(new Point2(u, v));
    result.setDirection(up.x(), up.y(), Math.copySign(up.z(), woZ));
    return up.z() != 0 && woZ != 0;
  }

  @Override
  public double importance(double cosine) {
    return albedo.max() * passed(cosine);
  }

  @Override
  public Rgb diffuseAlbedo() {
    return albedo;
  }
}
