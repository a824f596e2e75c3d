package io.github.lumbre.material;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Tilted;
import io.github.lumbre.math.Vec3;

/**
 * A layer above another BSDF: f = layer + base · min(1 - E(o), 1 - E(i)), where E is the layer's
 * directional albedo. The minimum keeps the sum reciprocal and at most 1. Above glass, smooth or
 * rough, which refracts to directions of other albedos, it would lose light that nothing absorbs;
 * there the factor is 1 - E(o), and the sum is not reciprocal.
 *
 * @param reflected fraction of the light from a direction that the layer reflects
 */
record Layered(Bsdf layer, Bsdf base, Albedo reflected) implements Bsdf {
  /** The largest random number. */
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  /** The directional albedo of a layer. */
  @FunctionalInterface
  interface Albedo {
    /** Returns the fraction of light from a unit direction that the layer reflects, in [0,1]. */
    double at(double x, double y, double z);
  }

  private double passed(double reflectedOut, double wiX, double wiY, double wiZ) {
    return isGlass(base)
        ? 1 - reflectedOut
        : Math.max(0, 1 - Math.max(reflectedOut, reflected.at(wiX, wiY, wiZ)));
  }

  /** Returns whether smooth glass or facets transmit light, not only a diffuse lobe. */
  private static boolean isGlass(Bsdf base) {
    if (base instanceof Layered layered) {
      return isGlass(layered.base);
    }
    if (base instanceof Tilted tilted) {
      return isGlass(tilted.bsdf());
    }
    if (base instanceof Blend blend) {
      return isGlass(blend.first()) || isGlass(blend.second());
    }
    // A mixture transmits only by diffuse transmission.
    return base.transmits() && !(base instanceof Mixture);
  }

  /** Returns the probability of sampling the layer. */
  private static double share(double reflectedOut) {
    return Math.min(.9, Math.max(.1, reflectedOut));
  }

  @Override
  public Bsdf narrowed(Rgb throughput) {
    return new Layered(layer, base.narrowed(throughput), reflected);
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public boolean isTransmissive() {
    return base.isTransmissive();
  }

  @Override
  public boolean transmits() {
    return base.transmits();
  }

  @Override
  public Rgb diffuseAlbedo() {
    return base.diffuseAlbedo();
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    double reflectedOut = reflected.at(woX, woY, woZ);
    double share = share(reflectedOut);
    layer.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    Rgb f = result.f();
    double pdf = share * result.pdf();
    base.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    Rgb below = result.f().times(passed(reflectedOut, wiX, wiY, wiZ));
    result.set(f.plus(below), pdf + (1 - share) * result.pdf());
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    double reflectedOut = reflected.at(woX, woY, woZ);
    double share = share(reflectedOut);
    if (uLobe < share) {
      layer.sample(woX, woY, woZ, uLobe / share, u, v, result);
    } else {
      double uRest = Math.min(BELOW_ONE, (uLobe - share) / (1 - share));
      base.sample(woX, woY, woZ, uRest, u, v, result);
    }
    if (result.isAbsorbed()) {
      return;
    }
    if (result.isSpecular()) {
      double passed = passed(reflectedOut, result.x(), result.y(), result.z());
      result.setSpecular(result.wi(), result.weight().times(passed / (1 - share)));
    } else {
      result.weighBy(this, new Vec3(woX, woY, woZ));
    }
  }

  @Override
  public Rgb albedo() {
    return layer.albedo().plus(base.albedo()).clampedToOne();
  }

  @Override
  public Rgb clearAlbedo() {
    return layer.clearAlbedo().plus(base.clearAlbedo()).clampedToOne();
  }
}
