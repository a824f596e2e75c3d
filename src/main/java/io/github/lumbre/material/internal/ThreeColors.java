package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Vec3;

/**
 * A BSDF that scatters each color in its own way. It samples one of the three, in proportion to the
 * colors that the path carries; the weight and the density include all of them.
 *
 * @param red scatters red light; its other colors are ignored
 * @param carried throughput of the path, per color, at least 0 and not black
 */
public record ThreeColors(Bsdf red, Bsdf green, Bsdf blue, Rgb carried) implements Bsdf {
  /** The largest random number. */
  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  @Override
  public Bsdf narrowed(Rgb throughput) {
    return throughput.isBlack() ? this : new ThreeColors(red, green, blue, throughput);
  }

  @Override
  public boolean isBareGlass() {
    return true;
  }

  @Override
  public boolean isTransmissive() {
    return green.isTransmissive();
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    red.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    double r = result.r();
    double pdf = carried.r() * result.pdf();
    green.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    double g = result.g();
    pdf += carried.g() * result.pdf();
    blue.evaluate(woX, woY, woZ, wiX, wiY, wiZ, result);
    pdf += carried.b() * result.pdf();
    result.set(new Rgb(r, g, result.b()), pdf / sum());
  }

  private double sum() {
    return carried.r() + carried.g() + carried.b();
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    double choice = uLobe * sum();
    double afterRed = choice - carried.r();
    double afterGreen = afterRed - carried.g();
    // What is left of the random number is uniform again.
    if (afterRed < 0) {
      red.sample(woX, woY, woZ, choice / carried.r(), u, v, result);
    } else if (afterGreen < 0) {
      green.sample(woX, woY, woZ, afterRed / carried.g(), u, v, result);
    } else {
      double rest = Math.min(BELOW_ONE, afterGreen / carried.b());
      blue.sample(woX, woY, woZ, carried.b() > 0 ? rest : 0, u, v, result);
    }
    if (!result.isAbsorbed()) {
      result.weighBy(this, new Vec3(woX, woY, woZ));
    }
  }

  @Override
  public Rgb albedo() {
    return new Rgb(red.albedo().r(), green.albedo().g(), blue.albedo().b());
  }

  @Override
  public Rgb clearAlbedo() {
    return new Rgb(red.clearAlbedo().r(), green.clearAlbedo().g(), blue.clearAlbedo().b());
  }
}
