package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Fresnel;
import io.github.lumbre.material.internal.Microfacets;
import io.github.lumbre.math.Vec3;

/**
 * Microfacet reflection with the exact Fresnel equations, on both sides of the surface: f = F D G /
 * (4 cos θo cos θi), with height-correlated masking (Cook &amp; Torrance 1982; PBRT 4e, sec. 9.6).
 * Light that hits more than one microfacet is lost.
 *
 * @param specular tints the reflection, each component in [0,1]
 * @param ior index of refraction of the facets, &gt; 0
 * @param facets distribution of the microfacet normals
 */
record MicrofacetReflection(Rgb specular, double ior, Microfacets facets) implements Lobe {
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
    // Half the sum's length is the cosine at the facet. A dot product would lose digits.
    double fresnel = Fresnel.dielectric(Math.min(1, .5 * sum.length()), ior);
    // Reflection divides the density of visible normals by 4 times that cosine, which cancels.
    double visible = facets.visible(o.z());
    double pdf = facets.density(sum.normalized()) / (4 * visible);
    result.set(specular.times(fresnel * facets.maskingRatio(o.z(), visible, i.z()) * pdf), pdf);
  }

  @Override
  public boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    return facets.draw(woX, woY, woZ, u, v, result);
  }

  @Override
  public double importance(double cosine) {
    return specular.max() * Fresnel.dielectric(Math.abs(cosine), ior);
  }

  @Override
  public Rgb albedo() {
    return specular.times(Fresnel.dielectric(1, ior));
  }

  @Override
  public Rgb clearAlbedo() {
    return facets.areClear() ? albedo() : Rgb.BLACK;
  }
}
