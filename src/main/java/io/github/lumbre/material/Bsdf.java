package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * The bidirectional scattering distribution function (BSDF) of one point of a surface. Directions
 * are unit vectors in the local shading frame and point away from the surface. Immutable.
 */
public interface Bsdf {
  /**
   * Computes f·|cos θi| and the density per solid angle with which {@link #sample} draws wi. Delta
   * lobes contribute to neither. This method is for the hot path: with plain numbers and a reused
   * result it allocates nothing. Other callers use {@link #evaluate(Vec3, Vec3)}.
   *
   * @param woX x of the direction to the viewer: local, of unit length
   * @param wiX x of the direction to the light: local, of unit length
   * @param result receives both values
   */
  void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result);

  /**
   * Returns f·|cos θi| and the density per solid angle with which {@link #sample} draws wi. Delta
   * lobes contribute to neither.
   *
   * @param wo direction to the viewer: local, of unit length
   * @param wi direction to the light: local, of unit length
   */
  default BsdfValue evaluate(Vec3 wo, Vec3 wi) {
    BsdfValue result = new BsdfValue();
    evaluate(wo.x(), wo.y(), wo.z(), wi.x(), wi.y(), wi.z(), result);
    return result;
  }

  /**
   * Returns the density per solid angle with which {@link #sample} draws wi, without delta lobes.
   */
  default double pdf(Vec3 wo, Vec3 wi) {
    return evaluate(wo, wi).pdf();
  }

  /**
   * Samples a direction in which light scatters. This method is for the hot path and allocates
   * nothing, like {@link #evaluate(double, double, double, double, double, double, BsdfValue)}.
   *
   * @param woX x of the direction to the viewer: local, of unit length
   * @param uLobe uniform in [0,1): selects a lobe if {@link #choosesLobe} returns true
   * @param u uniform in [0,1), as is v; the two determine the direction
   * @param result receives the direction; it is {@linkplain BsdfSample#isAbsorbed absorbed} if no
   *     light scatters
   */
  void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result);

  /**
   * Returns a sampled direction in which light scatters; it is {@linkplain BsdfSample#isAbsorbed
   * absorbed} if no light scatters.
   *
   * @param wo direction to the viewer: local, of unit length
   * @param uLobe uniform in [0,1): selects a lobe if {@link #choosesLobe} returns true
   * @param u uniform in [0,1)²: determines the direction
   */
  default BsdfSample sample(Vec3 wo, double uLobe, Point2 u) {
    BsdfSample result = new BsdfSample();
    sample(wo.x(), wo.y(), wo.z(), uLobe, u.x(), u.y(), result);
    return result;
  }

  /** Returns whether {@link #sample} uses {@code uLobe}. */
  default boolean choosesLobe() {
    return false;
  }

  /** Returns whether all lobes are delta lobes, so that light sampling would find no light. */
  default boolean isSpecular() {
    return false;
  }

  /** Returns whether light from behind the surface can scatter to the viewer. */
  default boolean isTransmissive() {
    return false;
  }

  /** Returns whether the surface is nothing but glass between two media. */
  default boolean isBareGlass() {
    return false;
  }

  /** Returns whether rays can pass the surface, by any lobe, also a delta lobe. */
  default boolean transmits() {
    return isTransmissive();
  }

  /**
   * Returns the same scattering, sampled for a path whose throughput is known. Only materials that
   * {@linkplain Material#isDispersive disperse} light make a difference.
   *
   * @param throughput each component at least 0
   */
  default Bsdf narrowed(Rgb throughput) {
    return this;
  }

  /**
   * Returns the albedo of the diffuse lobe, which reflects ambient light; black if there is none.
   */
  default Rgb diffuseAlbedo() {
    return Rgb.BLACK;
  }

  /**
   * Returns the color of the surface at normal incidence, without light: the fraction of light that
   * it reflects or transmits, roughly. Denoisers and compositing programs use it; light transport
   * does not. Each component is in [0,1].
   *
   * <p>A diffuse surface has its albedo, a metal its reflectance at normal incidence, glass the
   * color of its transmitted light.
   */
  Rgb albedo();

  /**
   * Returns the part of {@link #albedo} whose light comes from where a mirror or clear glass would
   * send it, so that other surfaces can be recognized in it: that of delta lobes and of lobes
   * hardly wider.
   */
  default Rgb clearAlbedo() {
    return isSpecular() ? albedo() : Rgb.BLACK;
  }
}
