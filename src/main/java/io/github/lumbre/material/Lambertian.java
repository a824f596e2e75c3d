package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;

/**
 * The ideal diffuse reflector: f = albedo / π, on both sides of the surface (PBRT 4e, sec. 9.2).
 *
 * @param albedo fraction of the light that is reflected, each component in [0,1]
 */
record Lambertian(Rgb albedo) implements Lobe {
  @Override
  public double pdf(Vec3 wo, Vec3 wi) {
    return wo.z() * wi.z() > 0 ? Warp.cosineHemispherePdf(Math.abs(wi.z())) : 0;
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    Vec3 wi = new Vec3(wiX, wiY, wiZ);
    if (wo.z() * wi.z() > 0) {
      double pdf = Warp.cosineHemispherePdf(Math.abs(wi.z()));
      result.set(albedo.r() * pdf, albedo.g() * pdf, albedo.b() * pdf, pdf);
    } else {
      result.clear();
    }
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    Vec3 up = Warp.cosineHemisphere(new Point2(u, v));
    if (up.z() == 0 || wo.z() == 0) {
      result.absorb();
      return;
    }
    Vec3 wi = new Vec3(up.x(), up.y(), Math.copySign(up.z(), wo.z()));
    result.set(wi, albedo, Warp.cosineHemispherePdf(up.z()));
  }

  @Override
  public double importance(double cosine) {
    return albedo.max();
  }

  @Override
  public Rgb diffuseAlbedo() {
    return albedo;
  }
}
