package io.github.lumbre.lab.checks;

import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;

/** Invariants of rays and surfaces. */
final class GeometryInvariants {
  private static final int RAYS = 60_000;
  private static final int HITS = 4_000;
  private static final int SPAWNED = 8;
  private static final double MILLION = 1e6;

  /** Pairs of a size and a distance from the origin, with a ratio of at most 1e9. */
  private static final double[][] PLACES = {
    {1e-9, 0}, {1e-6, 1e2}, {1e-3, 0}, {1, 0}, {1, 1e4}, {1, 1e8}, {1e3, 1e8}, {1e6, 0}, {1e9, 0}
  };

  private GeometryInvariants() {}

  static List<Invariant> all() {
    return List.of(
        new Invariant(
            "watertight",
            "rays per million that leak through a closed mesh at edges and vertices",
            "scales 1e-9 to 1e9, distances from the origin to 1e8, both kernels",
            0,
            GeometryInvariants::leaks),
        new Invariant(
            "no-rehit",
            "rays per million that hit the convex surface they leave a second time",
            "spheres, boxes, rectangles, meshes; scales 1e-9 to 1e9, distances to 1e8",
            0,
            GeometryInvariants::rehits),
        new Invariant(
            "sphere-outline",
            "rays per million that miss a sphere inside its outline or hit it outside",
            "from 10 to 1e12 radii away, 0.999 and 1.001 radii off the center",
            0,
            GeometryInvariants::outlines),
        new Invariant(
            "sphere-residual",
            "distance of hits from the sphere, in 2^-52 (distance + radius)",
            "from 10 to 1e12 radii away",
            8,
            GeometryInvariants::residuals),
        new Invariant(
            "kernels-agree",
            "rays per million for which the vector and scalar kernels find different hits",
            Kernel.vectorObstacle().isEmpty()
                ? "8064 triangles, rays from inside and outside"
                : "not tested: " + Kernel.vectorObstacle().get(),
            0,
            GeometryInvariants::kernelDifferences));
  }

  private static Kernel[] kernels() {
    return Kernel.vectorObstacle().isEmpty()
        ? new Kernel[] {Kernel.SCALAR, Kernel.VECTOR}
        : new Kernel[] {Kernel.SCALAR};
  }

  private static Transform place(double scale, double offset) {
    return Transform.translation(new Vec3(offset, -offset, .7 * offset))
        .times(Transform.rotationDegrees(new Vec3(17, 113, -71)))
        .times(Transform.scale(new Vec3(scale, scale, scale)));
  }

  private static double leaks(Tries tries) {
    Ball ball = Ball.of(16, .2);
    long leaks = 0;
    long rays = 0;
    for (Kernel kernel : kernels()) {
      for (double[] place : PLACES) {
        leaks += leaks(ball, place(place[0], place[1]), kernel, tries);
        rays += tries.times() * RAYS;
      }
    }
    return leaks * MILLION / rays;
  }

  private static long leaks(Ball ball, Transform place, Kernel kernel, Tries tries) {
    Bvh bvh = Bvh.over(List.of(Mesh.baked(ball.mesh(), place)), kernel);
    NearestHit hit = new NearestHit();
    Draws draws = tries.draws(1);
    long leaks = 0;
    for (int i = 0; i < tries.times() * RAYS; i++) {
      Vec3 inside = place.point(draws.direction().times(.5 * draws.unit()));
      Vec3[] corners = ball.triangle(draws);
      Vec3 a = place.point(corners[0]);
      Vec3 b = place.point(corners[1]);
      Vec3 target = i % 2 == 0 ? a : a.plus(draws.unit(), b.minus(a));
      Ray ray = new Ray(inside, target.minus(inside).normalized());
      leaks += bvh.intersect(ray, hit) && bvh.isOccluded(ray, hit) ? 0 : 1;
    }
    return leaks;
  }

  private static double rehits(Tries tries) {
    long rehits = 0;
    long rays = 0;
    for (double[] placed : PLACES) {
      Transform place = place(placed[0], placed[1]);
      for (Shape shape : convexShapes(place)) {
        long[] counted = rehits(shape, place, tries);
        rehits += counted[0];
        rays += counted[1];
      }
    }
    return rehits * MILLION / rays;
  }

  private static List<Shape> convexShapes(Transform place) {
    Ball octahedron = Ball.of(4, 0);
    return List.of(
        new Sphere(place, 1),
        new Box(place, 1, 1.5, .7),
        new Rectangle(place, 2, 1, true),
        Mesh.baked(octahedron.mesh(), place));
  }

  private static long[] rehits(Shape shape, Transform place, Tries tries) {
    Bvh bvh = Bvh.over(List.of(shape), Kernel.SCALAR);
    NearestHit hit = new NearestHit();
    NearestHit again = new NearestHit();
    Draws draws = tries.draws(2);
    long[] counted = new long[2];
    for (int i = 0; i < tries.times() * HITS; i++) {
      Vec3 from = place.point(draws.direction().times(draws.between(3, 50)));
      Vec3 to = place.point(draws.direction().times(.3 * draws.unit()));
      Ray ray = new Ray(from, to.minus(from).normalized());
      if (!bvh.intersect(ray, hit)) {
        continue;
      }
      SurfaceHit surface = shape.surfaceAt(hit);
      Vec3 normal = surface.geometricNormal();
      double side = Math.copySign(1, surface.wo().dot(normal));
      for (int k = 0; k < SPAWNED; k++) {
        Vec3 direction = draws.direction();
        double up = direction.dot(normal) * side;
        Vec3 outward = up >= 0 ? direction : direction.negated();
        counted[0] += bvh.intersect(surface.spawn(outward), again) ? 1 : 0;
        counted[1]++;
      }
    }
    return counted;
  }

  /** Samples a ray from a distance that passes the origin at an impact parameter. */
  private static Ray passing(Draws draws, double distance, double impact) {
    Vec3 axis = draws.direction();
    Vec3 across = axis.cross(draws.direction()).normalized();
    Vec3 from = axis.times(distance);
    return new Ray(from, across.times(impact).minus(from).normalized());
  }

  /** Returns the offset of the target from the center that gives a ray its impact parameter. */
  private static double offset(double impact, double distance) {
    return impact * distance / Math.sqrt(Math.max(distance * distance - impact * impact, 1e-300));
  }

  private static double outlines(Tries tries) {
    Bvh sphere = Bvh.over(List.of(new Sphere(Transform.IDENTITY, 1)), Kernel.SCALAR);
    NearestHit hit = new NearestHit();
    Draws draws = tries.draws(3);
    long wrong = 0;
    long rays = 0;
    for (double distance = 10; distance <= 1e12; distance *= 10) {
      for (int i = 0; i < tries.times() * (RAYS / 4); i++) {
        double inside = offset(.999 * Math.sqrt(draws.unit()), distance);
        double outside = offset(draws.between(1.001, 1.1), distance);
        // A hit beyond the center is on the far side, so it counts as a miss.
        boolean isMet = sphere.intersect(passing(draws, distance, inside), hit);
        wrong += isMet && hit.t() < distance ? 0 : 1;
        wrong += sphere.intersect(passing(draws, distance, outside), hit) ? 1 : 0;
        rays += 2;
      }
    }
    return wrong * MILLION / rays;
  }

  private static double residuals(Tries tries) {
    Sphere sphere = new Sphere(Transform.IDENTITY, 1);
    Bvh bvh = Bvh.over(List.of(sphere), Kernel.SCALAR);
    NearestHit hit = new NearestHit();
    Draws draws = tries.draws(4);
    double worst = 0;
    for (double distance = 10; distance <= 1e12; distance *= 10) {
      for (int i = 0; i < tries.times() * (RAYS / 4); i++) {
        Ray ray = passing(draws, distance, offset(.999 * draws.unit(), distance));
        if (bvh.intersect(ray, hit)) {
          double unit = Invariants.EPSILON * (distance + 1);
          double searched = Math.abs(ray.at(hit.t()).length() - 1);
          double stored = Math.abs(sphere.surfaceAt(hit).position().length() - 1);
          worst = Math.max(worst, Math.max(searched, stored) / unit);
        }
      }
    }
    return worst;
  }

  private static double kernelDifferences(Tries tries) {
    if (Kernel.vectorObstacle().isPresent()) {
      return 0;
    }
    List<Shape> shapes = List.of(Mesh.baked(Ball.of(64, .1).mesh(), place(3, 10)));
    Bvh scalar = Bvh.over(shapes, Kernel.SCALAR);
    Bvh vector = Bvh.over(shapes, Kernel.VECTOR);
    NearestHit one = new NearestHit();
    NearestHit other = new NearestHit();
    Draws draws = tries.draws(5);
    int rays = 4 * tries.times() * RAYS;
    long differences = 0;
    for (int i = 0; i < rays; i++) {
      Vec3 from = place(3, 10).point(draws.direction().times(2 * draws.unit()));
      Ray ray = new Ray(from, draws.direction());
      boolean hits = scalar.intersect(ray, one);
      boolean isSame = vector.intersect(ray, other) == hits;
      differences += isSame && (!hits || one.t() == other.t()) ? 0 : 1;
    }
    return differences * MILLION / rays;
  }
}
