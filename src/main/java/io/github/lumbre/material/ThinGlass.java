package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.ThinFilm;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * A thin rough pane: each GGX facet reflects by Schlick's approximation and transmits the rest,
 * tinted, in the mirror image of the reflected direction below the surface (KHR_materials_
 * transmission). Refraction at entry and exit cancels.
 *
 * @param tint of transmitted light, each component in [0,1]
 * @param f0 reflectance at normal incidence, each component in [0,1]
 * @param f90 reflectance at grazing incidence, in [0,1]
 * @param film above the facets
 */
record ThinGlass(Rgb tint, Rgb f0, double f90, Ggx facets, ThinFilm film) implements Bsdf {
  @Override
  public boolean isTransmissive() {
    return true;
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    if (woZ == 0 || wiZ == 0) {
      result.clear();
      return;
    }
    boolean reflects = woZ * wiZ > 0;
    double side = Math.signum(woZ);
    Vec3 o = new Vec3(woX, woY, woZ).times(side);
    // The reflected direction that belongs to wi.
    Vec3 i = new Vec3(wiX * side, wiY * side, Math.abs(wiZ));
    Vec3 sum = o.plus(i);
    Rgb fresnel = SchlickReflection.fresnel(f0, f90, film, .5 * sum.length());
    double probability = reflectProbability(fresnel);
    double visible = facets.visible(o.z());
    double pdf = facets.density(sum.normalized()) / (4 * visible);
    double scale = facets.maskingRatio(o.z(), visible, i.z()) * pdf;
    Rgb share = reflects ? fresnel : passed(fresnel);
    result.set(share.times(scale), pdf * (reflects ? probability : 1 - probability));
  }

  private Rgb passed(Rgb fresnel) {
    return passed(tint, fresnel);
  }

  /** Returns the part of light that a pane transmits of what its facets do not reflect. */
  static Rgb passed(Rgb tint, Rgb fresnel) {
    return new Rgb(
        tint.r() * (1 - fresnel.r()), tint.g() * (1 - fresnel.g()), tint.b() * (1 - fresnel.b()));
  }

  private double reflectProbability(Rgb fresnel) {
    double reflected = fresnel.max();
    double sum = reflected + passed(fresnel).max();
    return sum == 0 ? 1 : reflected / sum;
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    double side = woZ > 0 ? 1 : -1;
    Vec3 o = new Vec3(woX, woY, woZ).times(side);
    Vec3 m = facets.sampleVisible(o, new Point2(u, v));
    double cosine = o.dot(m);
    Vec3 i = m.times(2 * cosine).minus(o).normalized();
    if (woZ == 0 || !(i.z() > 0)) {
      result.absorb();
      return;
    }
    Rgb fresnel = SchlickReflection.fresnel(f0, f90, film, cosine);
    boolean reflects = uLobe < reflectProbability(fresnel);
    result.setDirection(i.x() * side, i.y() * side, (reflects ? side : -side) * i.z());
    result.weighBy(this, new Vec3(woX, woY, woZ));
  }

  @Override
  public Rgb albedo() {
    return tint;
  }

  @Override
  public Rgb clearAlbedo() {
    return facets.areClear() ? albedo() : Rgb.BLACK;
  }
}
