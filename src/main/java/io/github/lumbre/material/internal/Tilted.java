package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;

/**
 * A BSDF whose normal differs from the surface's normal. A direction on different sides of both
 * shading planes scatters no light.
 *
 * @param frame around the BSDF's normal, in the surface's shading frame
 */
public record Tilted(Bsdf bsdf, Frame frame) implements BsdfAround {
  /**
   * Returns a BSDF around another normal; the BSDF itself if the viewer is behind that normal.
   *
   * @param normal unit vector in the surface's shading frame
   * @param wo direction to the viewer, in the surface's shading frame
   */
  public static Bsdf of(Bsdf bsdf, Vec3 normal, Vec3 wo) {
    return wo.dot(normal) * wo.z() > 0 ? new Tilted(bsdf, Frame.around(normal)) : bsdf;
  }

  /** Returns the absolute cosine of the angle between a unit direction and the BSDF's normal. */
  public double cosine(double x, double y, double z) {
    Vec3 n = frame.normal();
    return Math.min(1, Math.abs(n.x() * x + n.y() * y + n.z() * z));
  }

  @Override
  public void evaluate(
      double woX, double woY, double woZ, double wiX, double wiY, double wiZ, BsdfValue result) {
    Vec3 wo = frame.toLocal(new Vec3(woX, woY, woZ));
    Vec3 wi = frame.toLocal(new Vec3(wiX, wiY, wiZ));
    if (wi.z() * wiZ > 0 && wo.z() * woZ > 0) {
      bsdf.evaluate(wo.x(), wo.y(), wo.z(), wi.x(), wi.y(), wi.z(), result);
    } else {
      result.clear();
    }
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = frame.toLocal(new Vec3(woX, woY, woZ));
    bsdf.sample(wo.x(), wo.y(), wo.z(), uLobe, u, v, result);
    if (result.isAbsorbed()) {
      return;
    }
    Vec3 wi = frame.toWorld(result.wi());
    if (wi.z() * result.z() > 0) {
      result.setDirection(wi);
    } else {
      result.absorb();
    }
  }

  @Override
  public Bsdf narrowed(Rgb throughput) {
    return new Tilted(bsdf.narrowed(throughput), frame);
  }
}
