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
   * Computes f·|cos θi| and the density per solid angle with which {@link #sample} draws wi; delta
   * lobes count for nothing in either. The hot path: no object is made.
   *
   * @param value holds the two directions; receives the result
   */
  void evaluate(BsdfValue value);

  /** Returns f·|cos θi| and the density, as {@link #evaluate(BsdfValue)} computes them. */
  default BsdfValue evaluate(Vec3 wo, Vec3 wi) {
    BsdfValue value = new BsdfValue();
    value.ask(wo.x(), wo.y(), wo.z(), wi.x(), wi.y(), wi.z());
    evaluate(value);
    return value;
  }

  /** Returns the density per solid angle with which {@link #sample} draws wi, delta lobes aside. */
  default double pdf(Vec3 wo, Vec3 wi) {
    return evaluate(wo, wi).pdf();
  }

  /**
   * Draws a direction.
   *
   * @param drawn asked for a viewer and random numbers; takes the result, {@linkplain
   *     BsdfSample#isAbsorbed absorbed} if the light ends here
   */
  void sample(BsdfSample drawn);

  /** Tells whether {@link #sample} looks at the number that chooses among lobes. */
  default boolean choosesLobe() {
    return false;
  }

  /**
   * Draws a direction into a new sample.
   *
   * @param uLobe uniform in [0,1): chooses among lobes, if {@link #choosesLobe} says so
   * @param u uniform in [0,1)²
   */
  default BsdfSample sample(Vec3 wo, double uLobe, Point2 u) {
    BsdfSample drawn = new BsdfSample();
    drawn.ask(wo.x(), wo.y(), wo.z(), uLobe, u);
    sample(drawn);
    return drawn;
  }

  /** Tells whether all lobes are deltas, so that light sampling is pointless. */
  default boolean isSpecular() {
    return false;
  }

  /** Tells whether light from behind the surface may scatter to the viewer. */
  default boolean isTransmissive() {
    return false;
  }

  /** Returns the albedo of the diffuse lobe, which ambient light asks for. */
  default Rgb diffuseAlbedo() {
    return Rgb.BLACK;
  }
}
