package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.ThinFilm;
import io.github.lumbre.math.Vec3;

/**
 * Reflection by GGX facets with Schlick's approximation of Fresnel's equations, F = F0 + (F90 - F0)
 * (1 - cos)^5 (Schlick 1994; glTF 2.0, Appendix B.3), on both sides of the surface. Light that hits
 * more than one facet is lost.
 *
 * @param f0 reflectance at normal incidence, each component in [0,1]
 * @param f90 reflectance at grazing incidence, in [0,1]
 * @param film above the facets
 */
record SchlickReflection(Rgb f0, double f90, Ggx facets, ThinFilm film) implements Lobe {
  SchlickReflection(Rgb f0, double f90, Ggx facets) {
    this(f0, f90, facets, ThinFilm.NONE);
  }

  /** Cosines at which {@link #boundingF0} compares reflectances. */
  private static final double[] COSINES = {1, .8, .6, .4, .25, .15, .08, .03};

  /** Returns (1 - cos)^5. */
  static double grazing(double cosine) {
    double c = 1 - cosine;
    double c2 = c * c;
    return c2 * c2 * c;
  }

  /** Returns the reflectance of a facet. */
  static Rgb fresnel(Rgb f0, double f90, double cosine) {
    double s = grazing(Math.min(1, cosine));
    return new Rgb(
        f0.r() + (f90 - f0.r()) * s, f0.g() + (f90 - f0.g()) * s, f0.b() + (f90 - f0.b()) * s);
  }

  /** Returns the reflectance of a facet that has a film. */
  static Rgb fresnel(Rgb f0, double f90, ThinFilm film, double cosine) {
    return film.over(fresnel(f0, f90, cosine), f0, f90, cosine);
  }

  /**
   * Returns the reflectance at normal incidence of a surface without a film that reflects at least
   * as much as this one, of each color and at each angle.
   */
  double boundingF0() {
    if (film.strength() == 0) {
      return f0.max();
    }
    double largest = 0;
    for (double cosine : COSINES) {
      double s = grazing(cosine);
      double reflected = fresnel(f0, f90, film, cosine).max();
      largest = Math.max(largest, (reflected - f90 * s) / (1 - s));
    }
    return largest;
  }

  /**
   * Returns the mean reflectance of a facet under uniform radiance: F0 + (F90 - F0) / 21, and about
   * what a film changes at the mean cosine, 2/3.
   */
  static Rgb meanFresnel(Rgb f0, double f90, ThinFilm film) {
    Rgb plain = f0.times(20.0 / 21).plus(Rgb.gray(f90 / 21));
    if (film.strength() == 0) {
      return plain;
    }
    Rgb with = fresnel(f0, f90, film, 2.0 / 3);
    Rgb without = fresnel(f0, f90, 2.0 / 3);
    return new Rgb(
            Math.max(0, plain.r() + with.r() - without.r()),
            Math.max(0, plain.g() + with.g() - without.g()),
            Math.max(0, plain.b() + with.b() - without.b()))
        .clampedToOne();
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    if (!(woZ * wiZ > 0)) {
      result.clear();
      return;
    }
    double side = Math.signum(woZ);
    Vec3 o = new Vec3(woX, woY, woZ).times(side);
    Vec3 i = new Vec3(wiX, wiY, wiZ).times(side);
    Vec3 sum = o.plus(i);
    double visible = facets.visible(o.z());
    double pdf = facets.density(sum.normalized()) / (4 * visible);
    // Half the sum is as long as the cosine at the facet.
    Rgb fresnel = fresnel(f0, f90, film, .5 * sum.length());
    result.set(fresnel.times(facets.maskingRatio(o.z(), visible, i.z()) * pdf), pdf);
  }

  @Override
  public boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    return facets.draw(woX, woY, woZ, u, v, result);
  }

  @Override
  public double importance(double cosine) {
    return GgxAlbedo.of(albedo().max(), f90, Math.abs(cosine), facets.alpha());
  }

  @Override
  public Rgb albedo() {
    return film.over(f0, f0, f90, 1);
  }

  @Override
  public Rgb clearAlbedo() {
    return facets.areClear() ? albedo() : Rgb.BLACK;
  }
}
