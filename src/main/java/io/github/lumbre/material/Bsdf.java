package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * How one point of a surface scatters, in its local frame. All directions are of unit length and
 * point away from the surface. Immutable.
 */
public interface Bsdf {
  /**
   * Computes f·|cos θi| and the density per solid angle with which {@link #sample} draws wi. Delta
   * lobes add nothing to either. This is the hot path: plain numbers and a reused result allocate
   * nothing; {@link #evaluate(Vec3, Vec3)} is the same for other callers.
   *
   * @param woX x of the direction to the viewer: local, of unit length
   * @param wiX x of the direction to the light: local, of unit length
   * @param result receives both values
   */
  void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result);

  /**
   * Returns f·|cos θi| and the density per solid angle with which {@link #sample} draws wi, delta
   * lobes aside.
   *
   * @param wo direction to the viewer: local, of unit length
   * @param wi direction to the light: local, of unit length
   */
  default BsdfValue evaluate(Vec3 wo, Vec3 wi) {
    BsdfValue result = new BsdfValue();
    evaluate(wo.x(), wo.y(), wo.z(), wi.x(), wi.y(), wi.z(), result);
    return result;
  }

  /** Returns the density per solid angle with which {@link #sample} draws wi, delta lobes aside. */
  default double pdf(Vec3 wo, Vec3 wi) {
    return evaluate(wo, wi).pdf();
  }

  /**
   * Samples a direction in which light scatters. This is the hot path, as in {@link
   * #evaluate(double, double, double, double, double, double, BsdfValue)}.
   *
   * @param woX x of the direction to the viewer: local, of unit length
   * @param uLobe uniform in [0,1): selects a lobe, if {@link #choosesLobe}
   * @param u uniform in [0,1), as is v: they determine the direction
   * @param result receives the direction, {@linkplain BsdfSample#isAbsorbed absorbed} if the light
   *     ends here
   */
  void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result);

  /**
   * Samples a direction in which light scatters, {@linkplain BsdfSample#isAbsorbed absorbed} if the
   * light ends here.
   *
   * @param wo direction to the viewer: local, of unit length
   * @param uLobe uniform in [0,1): selects a lobe, if {@link #choosesLobe}
   * @param u uniform in [0,1)²: determines the direction
   */
  default BsdfSample sample(Vec3 wo, double uLobe, Point2 u) {
    BsdfSample result = new BsdfSample();
    sample(wo.x(), wo.y(), wo.z(), uLobe, u.x(), u.y(), result);
    return result;
  }

  /** Returns whether {@link #sample} uses the number that selects a lobe. */
  default boolean choosesLobe() {
    return false;
  }

  /** Returns whether all lobes are deltas, so that light sampling is pointless. */
  default boolean isSpecular() {
    return false;
  }

  /** Returns whether light from behind the surface may scatter to the viewer. */
  default boolean isTransmissive() {
    return false;
  }

  /** Returns the albedo of the diffuse lobe, which reflects ambient light. */
  default Rgb diffuseAlbedo() {
    return Rgb.BLACK;
  }
}
