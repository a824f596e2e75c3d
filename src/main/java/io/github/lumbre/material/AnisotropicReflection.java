package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Ggx;
import io.github.lumbre.material.internal.Microfacets;
import io.github.lumbre.material.internal.Microfacets;
import io.github.lumbre.material.internal.ThinFilm;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * Reflection by GGX facets that are rougher along one direction, as of brushed metal, with
 * Schlick's approximation of Fresnel's equations (KHR_materials_anisotropy; Heitz 2014, eq. 85 and
 * 86).
 *
 * @param f0 reflectance at normal incidence, each component in [0,1]
 * @param f90 reflectance at grazing incidence, in [0,1]
 * @param alphaAlong roughness along the direction, &gt; 0
 * @param alphaAcross roughness perpendicular to it, &gt; 0
 * @param cos cosine of the angle from the tangent to the direction, towards the bitangent
 * @param sin sine of that angle
 * @param film above the facets
 */
record AnisotropicReflection(
    Rgb f0,
    double f90,
    double alphaAlong,
    double alphaAcross,
    double cos,
    double sin,
    ThinFilm film)
    implements Lobe {
  /**
   * Returns the roughness along the direction of anisotropy.
   *
   * @param strength of the anisotropy, in [0,1]
   */
  static double alphaAlong(double alpha, double strength) {
    return alpha + (1 - alpha) * strength * strength;
  }

  /**
   * Returns the reflection that is rougher along a direction.
   *
   * @param direction relative to the tangent and bitangent; z is ignored, and 0 is the tangent
   * @param degrees rotation of the direction, from the tangent towards the bitangent
   * @param isotropic reflection as rough as this one perpendicular to the direction
   * @param strength of the anisotropy, in [0,1]
   */
  static AnisotropicReflection along(
      Vec3 direction, double degrees, SchlickReflection isotropic, double strength) {
    double length = Math.sqrt(direction.x() * direction.x() + direction.y() * direction.y());
    double x = length > 0 ? direction.x() / length : 1;
    double y = length > 0 ? direction.y() / length : 0;
    double cos = Elementary.cosDegrees(degrees);
    double sin = Elementary.sinDegrees(degrees);
    double alpha = isotropic.facets().alpha();
    return new AnisotropicReflection(
        isotropic.f0(),
        isotropic.f90(),
        alphaAlong(alpha, strength),
        alpha,
        cos * x - sin * y,
        sin * x + cos * y,
        isotropic.film());
  }

  /**
   * Returns the diffuse reflection below this layer. It uses the tables of isotropic layers, whose
   * albedo is up to 0.1 too small for anisotropic ones. A smoother layer and a smaller albedo make
   * up for that; both are fitted. In a scan over strength, roughness, F0 and directions, the sum
   * reflects at most 1.0022; AnisotropicReflectionTest requires at most 1.003.
   *
   * @param f0 the largest component of this layer's F0
   */
  static LayeredDiffuse below(Rgb albedo, double f0, double f90, double alpha, double strength) {
    double difference = Math.sqrt(1 - alpha / alphaAlong(alpha, strength));
    return new LayeredDiffuse(
        albedo.times(1 - difference * (f0 * f0 + .02)), f0, f90, alpha * (1 - .5 * difference));
  }

  /**
   * Returns a direction for a surface flipped so that it lies above, turned to the facets' axes.
   */
  private Vec3 toFacets(double x, double y, double z) {
    double side = z > 0 ? 1 : -1;
    return new Vec3(side * (cos * x + sin * y), side * (cos * y - sin * x), side * z);
  }

  /** Returns the density of facet normals; see {@link Microfacets#density}. */
  private double density(Vec3 m) {
    double alpha = Math.sqrt(alphaAlong * alphaAcross);
    double x = m.x() / alphaAlong;
    double y = m.y() / alphaAcross;
    double root = alpha * (x * x + y * y + m.z() * m.z());
    return m.z() <= 0 ? 0 : Elementary.INV_PI / (root * root);
  }

  /** Returns Λ · cos θ; see {@link Microfacets#hidden}. */
  private double hidden(Vec3 w) {
    double x = alphaAlong * w.x();
    double y = alphaAcross * w.y();
    return .5 * (Math.sqrt(w.z() * w.z() + x * x + y * y) - w.z());
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    if (!(woZ * wiZ > 0)) {
      result.clear();
      return;
    }
    Vec3 o = toFacets(woX, woY, woZ);
    Vec3 i = toFacets(wiX, wiY, wiZ);
    Vec3 sum = o.plus(i);
    double visible = o.z() + hidden(o);
    double pdf = density(sum.normalized()) / (4 * visible);
    double masking = 1 / (1 + hidden(i) / i.z() * (o.z() / visible));
    // Half the sum is as long as the cosine at the facet.
    Rgb fresnel = SchlickReflection.fresnel(f0, f90, film, .5 * sum.length());
    result.set(fresnel.times(masking * pdf), pdf);
  }

  /**
   * {@inheritDoc}
   *
   * <p>The facet is sampled among the visible ones: Heitz 2018, "Sampling the GGX Distribution of
   * Visible Normals".
   */
  @Override
  public boolean draw(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 o = toFacets(woX, woY, woZ);
    Vec3 stretched = new Vec3(alphaAlong * o.x(), alphaAcross * o.y(), o.z()).normalized();
    Vec3 n = new Ggx(1).sampleVisible(stretched, new Point2(u, v));
    Vec3 m = new Vec3(alphaAlong * n.x(), alphaAcross * n.y(), n.z()).normalized();
    Vec3 i = m.times(2 * o.dot(m)).minus(o).normalized();
    double side = woZ > 0 ? 1 : -1;
    result.setDirection(
        side * (cos * i.x() - sin * i.y()), side * (cos * i.y() + sin * i.x()), side * i.z());
    return woZ != 0 && i.z() > 0;
  }

  @Override
  public double importance(double cosine) {
    return GgxAlbedo.of(albedo().max(), f90, Math.abs(cosine), alphaAcross);
  }

  @Override
  public Rgb albedo() {
    return film.over(f0, f0, f90, 1);
  }

  @Override
  public Rgb clearAlbedo() {
    return alphaAlong <= Microfacets.CLEAR ? albedo() : Rgb.BLACK;
  }
}
