package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;

/**
 * A point where a path meets a surface: the surface's Bsdf in world directions.
 *
 * <p>Interpolated and bent normals may put a direction on one side of the shading plane and on the
 * other of the true surface. Light never passes that way: such directions scatter nothing.
 *
 * @param wo direction back along the path, in the local frame
 */
record Vertex(SurfaceHit surface, Frame frame, Bsdf bsdf, Vec3 wo) {

  static Vertex at(SurfaceHit surface, Material material) {
    Frame frame = material.frame(surface);
    // A viewer behind the bent plane but before the true one sees the true one.
    double side = surface.wo().dot(surface.geometricNormal());
    if (side * surface.wo().dot(frame.normal()) <= 0) {
      frame = Frame.around(surface.geometricNormal());
    }
    return new Vertex(surface, frame, material.at(surface), frame.toLocal(surface.wo()));
  }

  /** Returns the normal on the side from which light scatters to the viewer; zero if on both. */
  Vec3 facing() {
    return bsdf.isTransmissive() ? Vec3.ZERO : frame.normal().times(Math.copySign(1, wo.z()));
  }

  /** Returns f·|cos θi| for a unit world direction. */
  Rgb eval(Vec3 wi) {
    Vec3 local = frame.toLocal(wi);
    return isConsistent(wi, local) ? bsdf.eval(wo, local) : Rgb.BLACK;
  }

  /** Returns the density per solid angle with which {@link #sample} draws a unit direction. */
  double pdf(Vec3 wi) {
    return bsdf.pdf(wo, frame.toLocal(wi));
  }

  /** Draws a direction; the sample's wi is in world space. */
  BsdfSample sample(double uLobe, Point2 u) {
    BsdfSample local = bsdf.sample(wo, uLobe, u);
    if (local.weight().isBlack()) {
      return BsdfSample.ABSORBED;
    }
    Vec3 wi = frame.toWorld(local.wi());
    return isConsistent(wi, local.wi())
        ? new BsdfSample(wi, local.weight(), local.pdf())
        : BsdfSample.ABSORBED;
  }

  private boolean isConsistent(Vec3 wi, Vec3 local) {
    return wi.dot(surface.geometricNormal())
            * (local.z() * wo.z())
            * surface.wo().dot(surface.geometricNormal())
        > 0;
  }
}
