package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.NormalGradient;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.Dielectric;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;

/**
 * A ray that surfaces of clear glass refract on its way to a plane, and the change of its end with
 * its first direction (Igehy 1999, "Tracing Ray Differentials"). Mutable; each thread reuses one
 * instance.
 */
final class GlassPath {
  /** The largest number of surfaces: the four of a hollow glass's two walls. */
  static final int MOST_SURFACES = 4;

  private final NearestHit probe = new NearestHit();
  private final Vertex vertex = new Vertex();
  private int surfaces;
  private int rays;
  private double passProbability;
  private Rgb passed = Rgb.WHITE;
  private Vec3 first = Vec3.ZERO;

  /** Origin and unit direction of the ray's last part. */
  private Vec3 origin = Vec3.ZERO;

  private Vec3 direction = Vec3.ZERO;
  private double length;

  /** Changes per step of the first direction along its two tangents. */
  private final Beam x = new Beam();

  private final Beam y = new Beam();

  /** The change of a ray for a small change of its first direction. */
  private static final class Beam {
    private Vec3 origin = Vec3.ZERO;
    private Vec3 direction = Vec3.ZERO;

    private void begin(Vec3 step) {
      origin = Vec3.ZERO;
      direction = step;
    }

    /**
     * Moves to where the ray meets a plane (Igehy 1999, eq. 10 to 12).
     *
     * @param along unit direction of the ray
     * @param normal of the plane, of either sign
     */
    private void move(double length, Vec3 along, Vec3 normal) {
      Vec3 moved = origin.plus(length, direction);
      origin = moved.plus(-moved.dot(normal) / along.dot(normal), along);
    }

    /**
     * Turns the direction as a surface refracts it (Igehy 1999, eq. 17 to 19).
     *
     * @param along unit direction of the ray before
     * @param normal unit shading normal on the side that the ray comes from
     * @param normalChange its change
     * @param ratio index of refraction of that side, relative to the other
     * @param cosine of the refracted direction and the normal, in [-1,0)
     */
    private void refract(Vec3 along, Vec3 normal, Vec3 normalChange, double ratio, double cosine) {
      double slope = along.dot(normal);
      double change = direction.dot(normal) + along.dot(normalChange);
      double mu = ratio * slope - cosine;
      double muChange = (ratio - ratio * ratio * slope / cosine) * change;
      direction = direction.times(ratio).plus(-mu, normalChange).plus(-muChange, normal);
    }
  }

  /**
   * Traces a ray through glass until it reaches a plane. A surface of another material counts as if
   * it were not there, and so does glass behind it.
   *
   * @param from where the ray starts, in world space
   * @param towards its unit direction
   * @param glass the clear glass of each primitive; null for all others
   * @param end a point of the plane
   * @param axis unit normal of the plane, on the other side of it
   * @return whether the ray meets glass and then the plane
   */
  boolean trace(Scene scene, Dielectric[] glass, Vec3 from, Vec3 towards, Vec3 end, Vec3 axis) {
    surfaces = 0;
    passProbability = 1;
    passed = Rgb.WHITE;
    first = towards;
    origin = from;
    direction = towards;
    Vec3 tangent = Frame.tangentAround(towards);
    x.begin(tangent);
    y.begin(towards.cross(tangent));
    while (true) {
      double slope = direction.dot(axis);
      length = end.minus(origin).dot(axis) / slope;
      boolean isTowards = slope > 0 && length > 0;
      probe.aim(new Ray(origin, direction, isTowards ? length : Double.POSITIVE_INFINITY));
      rays++;
      if (!scene.intersect(probe) || glass[probe.shape()] == null) {
        if (!isTowards || surfaces == 0) {
          return false;
        }
        x.move(length, direction, axis);
        y.move(length, direction, axis);
        return true;
      }
      if (surfaces == MOST_SURFACES || !refract(scene, glass[probe.shape()])) {
        return false;
      }
      surfaces++;
    }
  }

  /** Passes the surface that the ray hits; returns whether it does. */
  private boolean refract(Scene scene, Dielectric clear) {
    Primitive primitive = scene.primitiveAt(probe);
    SurfaceHit surface = scene.surfaceAt(probe);
    Vec3 smooth = surface.shadingNormal();
    vertex.moveTo(surface, primitive.material());
    Vec3 normal = surface.shadingNormal();
    NormalGradient gradient =
        normal.equals(smooth) ? primitive.shape().normalGradientAt(probe) : NormalGradient.FLAT;
    Vec3 wo = vertex.wo();
    passProbability *= clear.passProbability(wo);
    passed = passed.times(clear.passed(wo));
    Vec3 next = vertex.refracted(clear);
    if (!(passProbability > 0) || next.equals(Vec3.ZERO)) {
      return false;
    }
    double side = Math.copySign(1, wo.z());
    double ratio = 1 / clear.eta(wo);
    Vec3 facing = normal.times(side);
    double cosine = next.dot(facing);
    refract(x, surface, gradient, side, ratio, facing, cosine);
    refract(y, surface, gradient, side, ratio, facing, cosine);
    surface.spawn(next.x(), next.y(), next.z(), probe);
    origin = probe.origin();
    direction = next;
    return true;
  }

  private void refract(
      Beam beam,
      SurfaceHit surface,
      NormalGradient gradient,
      double side,
      double ratio,
      Vec3 facing,
      double cosine) {
    beam.move(probe.t(), direction, surface.geometricNormal());
    Vec3 normalChange = gradient.change(beam.origin).times(side);
    beam.refract(direction, facing, normalChange, ratio, cosine);
  }

  /** Returns the number of rays traced since the last call. */
  int takeRays() {
    int taken = rays;
    rays = 0;
    return taken;
  }

  /** Returns the number of surfaces that refract the ray. */
  int surfaces() {
    return surfaces;
  }

  /** Returns the probability with which scattered rays pass all surfaces. */
  double passProbability() {
    return passProbability;
  }

  /** Returns the fraction of light that passes all surfaces, per color. */
  Rgb passed() {
    return passed;
  }

  /** Returns the first direction of the ray, of unit length. */
  Vec3 first() {
    return first;
  }

  /** Returns the last direction of the ray, of unit length. */
  Vec3 last() {
    return direction;
  }

  /** Returns the last surface that refracts the ray. */
  SurfaceHit lastSurface() {
    return vertex.surface();
  }

  /** Returns where the ray meets the plane. */
  Vec3 end() {
    return origin.plus(length, direction);
  }

  /**
   * Returns the first direction that would move the ray's end by a step along the plane, if the end
   * changed linearly; NaN if there is none.
   *
   * @param axis unit normal of the plane
   */
  Vec3 turned(Vec3 step, Vec3 axis) {
    double area = x.origin.cross(y.origin).dot(axis);
    double dx = step.cross(y.origin).dot(axis) / area;
    double dy = x.origin.cross(step).dot(axis) / area;
    Vec3 tangent = Frame.tangentAround(first);
    return first.plus(dx, tangent).plus(dy, first.cross(tangent)).normalized();
  }

  /** Returns the area on the plane that a beam of rays covers per solid angle where it starts. */
  double spread(Vec3 axis) {
    return Math.abs(x.origin.cross(y.origin).dot(axis));
  }
}
