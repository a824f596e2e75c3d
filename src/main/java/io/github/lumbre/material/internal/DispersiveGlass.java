package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.math.Vec3;

/**
 * The BSDF of smooth glass with an index of refraction for each color. All colors are reflected to
 * one direction, but refracted to three: a sample follows one of them, and has that color alone.
 *
 * <p>What it samples depends on the colors that the path carries. A path that was refracted once
 * keeps its color at all further surfaces (hero wavelength sampling: Wilkie et al. 2014).
 *
 * @param tint of the refracted light, each component in [0,1]
 * @param iors index of refraction of the inside relative to the outside, per color, at least 1
 * @param carried throughput of the path, per color, at least 0
 */
public record DispersiveGlass(Rgb tint, Rgb iors, Rgb carried) implements SpecularBsdf {
  /** Creates the glass for a path that carries white light. */
  public DispersiveGlass(Rgb tint, Rgb iors) {
    this(tint, iors, Rgb.WHITE);
  }

  @Override
  public DispersiveGlass narrowed(Rgb throughput) {
    return new DispersiveGlass(tint, iors, throughput);
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

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    Rgb reflected =
        new Rgb(
            ofIndex(iors.r()).reflected(wo),
            ofIndex(iors.g()).reflected(wo),
            ofIndex(iors.b()).reflected(wo));
    double reflects = carried.r() * reflected.r();
    reflects += carried.g() * reflected.g() + carried.b() * reflected.b();
    double red = carried.r() * tint.r() * (1 - reflected.r());
    double green = carried.g() * tint.g() * (1 - reflected.g());
    double blue = carried.b() * tint.b() * (1 - reflected.b());
    double all = reflects + red + green + blue;
    double choice = uLobe * all - reflects;
    if (!(all > 0)) {
      result.absorb();
    } else if (choice < 0) {
      result.setSpecular(SpecularReflection.reflect(wo), reflected.times(all / reflects));
    } else if (choice < red) {
      result.setSpecular(ofIndex(iors.r()).refract(wo), new Rgb(all / carried.r(), 0, 0));
    } else if (choice < red + green) {
      result.setSpecular(ofIndex(iors.g()).refract(wo), new Rgb(0, all / carried.g(), 0));
    } else if (blue > 0) {
      result.setSpecular(ofIndex(iors.b()).refract(wo), new Rgb(0, 0, all / carried.b()));
    } else {
      // Rounding made the largest random number select what has no probability.
      result.absorb();
    }
  }

  @Override
  public Rgb albedo() {
    return tint;
  }

  /**
   * Returns rough glass with an index of refraction for each color.
   *
   * @param iors per color, above 1
   */
  public static Bsdf rough(Rgb tint, Rgb iors, Microfacets facets) {
    return new ThreeColors(
        new RoughDielectric(Rgb.WHITE, Rgb.grey(tint.r()), iors.r(), facets),
        new RoughDielectric(Rgb.WHITE, Rgb.grey(tint.g()), iors.g(), facets),
        new RoughDielectric(Rgb.WHITE, Rgb.grey(tint.b()), iors.b(), facets),
        Rgb.WHITE);
  }
}
