package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.math.Vec3;

/**
 * The BSDF of smooth glass whose reflectance depends on the color, because it has a thin film or an
 * index of refraction for each color. All colors are reflected in one direction. With different
 * indices, each color is refracted in its own direction, and a sample carries one color.
 *
 * <p>What it samples depends on the colors that the path carries. A path that was refracted once
 * keeps its color at all further surfaces (hero wavelength sampling: Wilkie et al. 2014).
 *
 * @param tint of the refracted light, each component in [0,1]
 * @param iors index of refraction of the inside relative to the outside, per color, at least 1
 * @param carried throughput of the path, per color, at least 0
 */
public record ChromaticGlass(Rgb tint, Rgb iors, ThinFilm film, Rgb carried)
    implements SpecularBsdf {
  /** Creates the glass for a path that carries white light. */
  public ChromaticGlass(Rgb tint, Rgb iors, ThinFilm film) {
    this(tint, iors, film, Rgb.WHITE);
  }

  @Override
  public ChromaticGlass narrowed(Rgb throughput) {
    return new ChromaticGlass(tint, iors, film, throughput);
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public boolean transmits() {
    return true;
  }

  private static Dielectric ofIndex(double ior) {
    return new Dielectric(Rgb.WHITE, Rgb.WHITE, ior);
  }

  /** Returns the fraction of light that is reflected, per color. */
  private Rgb reflected(Vec3 wo) {
    return new Rgb(
        film.over(0, Math.abs(wo.z()), wo.z() > 0, iors.r()),
        film.over(1, Math.abs(wo.z()), wo.z() > 0, iors.g()),
        film.over(2, Math.abs(wo.z()), wo.z() > 0, iors.b()));
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    Rgb reflected = reflected(wo);
    Rgb passed =
        new Rgb(
            tint.r() * (1 - reflected.r()),
            tint.g() * (1 - reflected.g()),
            tint.b() * (1 - reflected.b()));
    Rgb below = carried.times(passed);
    double above = sum(carried.times(reflected));
    double all = above + sum(below);
    double choice = uLobe * all - above;
    if (!(all > 0)) {
      result.absorb();
    } else if (choice < 0) {
      result.setSpecular(SpecularReflection.reflect(wo), reflected.times(all / above));
    } else if (iors.r() == iors.b()) {
      result.setSpecular(ofIndex(iors.g()).refract(wo), passed.times(all / sum(below)));
    } else if (choice < below.r()) {
      result.setSpecular(ofIndex(iors.r()).refract(wo), new Rgb(all / carried.r(), 0, 0));
    } else if (choice < below.r() + below.g()) {
      result.setSpecular(ofIndex(iors.g()).refract(wo), new Rgb(0, all / carried.g(), 0));
    } else if (below.b() > 0) {
      result.setSpecular(ofIndex(iors.b()).refract(wo), new Rgb(0, 0, all / carried.b()));
    } else {
      // Rounding made the largest random number select a color of probability 0.
      result.absorb();
    }
  }

  private static double sum(Rgb color) {
    return color.r() + color.g() + color.b();
  }

  @Override
  public Rgb albedo() {
    return tint;
  }

  /**
   * Returns rough glass with a film and an index of refraction for each color.
   *
   * @param iors per color, above 1
   */
  public static Bsdf rough(Rgb tint, Rgb iors, ThinFilm film, Microfacets facets) {
    return new ThreeColors(
        new RoughDielectric(Rgb.WHITE, Rgb.gray(tint.r()), iors.r(), facets, film, 0),
        new RoughDielectric(Rgb.WHITE, Rgb.gray(tint.g()), iors.g(), facets, film, 1),
        new RoughDielectric(Rgb.WHITE, Rgb.gray(tint.b()), iors.b(), facets, film, 2),
        Rgb.WHITE);
  }
}
