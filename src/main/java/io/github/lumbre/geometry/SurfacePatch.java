package io.github.lumbre.geometry;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.Optional;

/**
 * A flat piece of a surface whose shading normal varies linearly, such as a triangle with vertex
 * normals, extended to its whole plane. In world space. Immutable.
 *
 * @param origin a point of the plane, with the coordinates (0, 0)
 * @param x step of the first coordinate; not parallel to {@code y}
 * @param y step of the second coordinate
 * @param normal shading normal at the origin, of any length
 * @param normalX change of the normal along {@code x}
 * @param normalY change of the normal along {@code y}
 */
public record SurfacePatch(
    Vec3 origin, Vec3 x, Vec3 y, Vec3 normal, Vec3 normalX, Vec3 normalY) {
  private static final int MOST_STEPS = 20;

  /** A step, relative to the distance between both points, that ends the search. */
  private static final double CONVERGED = 1e-12;

  /** Returns a patch whose normal is the same everywhere. */
  static SurfacePatch flat(Vec3 origin, Vec3 x, Vec3 y, Vec3 normal) {
    return new SurfacePatch(origin, x, y, normal, Vec3.ZERO, Vec3.ZERO);
  }

  /** Returns a point of the plane in world space. */
  public Vec3 at(Point2 p) {
    return origin.plus(p.x(), x).plus(p.y(), y);
  }

  /** Returns the unit shading normal at a point of the plane. */
  public Vec3 normalAt(Point2 p) {
    return normal.plus(p.x(), normalX).plus(p.y(), normalY).normalized();
  }

  /**
   * Returns the point of the plane that refracts light from one point to the other, found by
   * Newton's method from the origin on; empty if it finds none. There, the half vector ωi + η ωo
   * is along the normal (Walter et al. 2007, "Microfacet Models for Refraction").
   *
   * @param from in world space
   * @param to in world space, on the other side of the plane
   * @param eta index of refraction on the side of {@code to}, relative to the other side
   */
  public Optional<Point2> refraction(Vec3 from, Vec3 to, double eta) {
    double tolerance = CONVERGED * to.minus(from).length();
    Point2 p = new Point2(0, 0);
    for (int step = 0; step < MOST_STEPS; step++) {
      Constraint c = new Constraint(from, to, eta, p);
      Vec3 dx = c.change(x, normalX);
      Vec3 dy = c.change(y, normalY);
      double a = dx.dot(x);
      double b = dy.dot(x);
      double d = dx.dot(y);
      double e = dy.dot(y);
      double f = c.slope.dot(x);
      double g = c.slope.dot(y);
      double determinant = a * e - b * d;
      double moveX = (b * g - e * f) / determinant;
      double moveY = (d * f - a * g) / determinant;
      p = new Point2(p.x() + moveX, p.y() + moveY);
      double length = x.times(moveX).plus(moveY, y).length();
      if (!(length < Double.POSITIVE_INFINITY)) {
        return Optional.empty();
      }
      if (length <= tolerance) {
        return isRefraction(from, to, p) ? Optional.of(p) : Optional.empty();
      }
    }
    return Optional.empty();
  }

  /** Returns whether the points are on opposite sides of both the surface and the shading plane. */
  private boolean isRefraction(Vec3 from, Vec3 to, Point2 p) {
    Vec3 flat = x.cross(y);
    Vec3 shading = normalAt(p);
    Vec3 a = from.minus(at(p));
    Vec3 b = to.minus(at(p));
    double side = Math.copySign(1, flat.dot(shading));
    return a.dot(shading) * b.dot(shading) < 0
        && a.dot(shading) * a.dot(flat) * side > 0
        && b.dot(shading) * b.dot(flat) * side > 0;
  }

  /**
   * Returns the solid angle that a beam has at {@code from} per area that it covers, after its
   * refraction, of a surface at {@code to}. By the implicit function theorem (Jakob and Marschner
   * 2012, "Manifold Exploration", sec. 4).
   *
   * @param p the point that {@link #refraction} found
   * @param surfaceNormal unit normal of the surface at {@code to}, of either sign
   * @return in steradians per unit of area, at least 0; infinite or NaN at a caustic's edge
   */
  public double solidAngle(Vec3 from, Vec3 to, double eta, Point2 p, Vec3 surfaceNormal) {
    Constraint c = new Constraint(from, to, eta, p);
    Vec3 dx = c.change(x, normalX);
    Vec3 dy = c.change(y, normalY);
    Vec3 u = Frame.tangentAround(surfaceNormal);
    Vec3 v = surfaceNormal.cross(u);
    Vec3 du = c.changeByTarget(u);
    Vec3 dv = c.changeByTarget(v);
    double here = dx.dot(x) * dy.dot(y) - dy.dot(x) * dx.dot(y);
    double there = du.dot(x) * dv.dot(y) - dv.dot(x) * du.dot(y);
    double area = Math.abs(x.cross(y).dot(c.in)) / (c.inLength * c.inLength);
    return Math.abs(there / here) * area;
  }

  /** The part of the half vector along the surface, which is zero at a refraction. */
  private final class Constraint {
    /** Unit directions to both points, and their distances. */
    final Vec3 in;

    final double inLength;
    private final Vec3 out;
    private final double outLength;
    private final double eta;
    private final Vec3 unit;
    private final double normalLength;
    private final Vec3 half;
    final Vec3 slope;

    Constraint(Vec3 from, Vec3 to, double eta, Point2 p) {
      Vec3 here = at(p);
      Vec3 a = from.minus(here);
      Vec3 b = to.minus(here);
      this.eta = eta;
      inLength = a.length();
      outLength = b.length();
      in = a.times(1 / inLength);
      out = b.times(1 / outLength);
      Vec3 n = normal.plus(p.x(), normalX).plus(p.y(), normalY);
      normalLength = n.length();
      unit = n.times(1 / normalLength);
      half = in.plus(eta, out);
      slope = half.plus(-half.dot(unit), unit);
    }

    /** Returns the derivative along a step on the surface. */
    Vec3 change(Vec3 step, Vec3 normalStep) {
      Vec3 dIn = in.times(in.dot(step)).minus(step).times(1 / inLength);
      Vec3 dOut = out.times(out.dot(step)).minus(step).times(1 / outLength);
      Vec3 dHalf = dIn.plus(eta, dOut);
      Vec3 dUnit = normalStep.plus(-unit.dot(normalStep), unit).times(1 / normalLength);
      return dHalf
          .plus(-dHalf.dot(unit) - half.dot(dUnit), unit)
          .plus(-half.dot(unit), dUnit);
    }

    /** Returns the derivative along a step of the second point. */
    Vec3 changeByTarget(Vec3 step) {
      Vec3 dHalf = step.minus(out.times(out.dot(step))).times(eta / outLength);
      return dHalf.plus(-dHalf.dot(unit), unit);
    }
  }
}
