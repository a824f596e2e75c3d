package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** Shapes, rays and reference intersection functions for tests. */
final class Shapes {
  private Shapes() {}

  static Vec3 direction(Random random) {
    return Warp.uniformSphere(square(random)).normalized();
  }

  static Point2 square(Random random) {
    return new Point2(random.nextDouble(), random.nextDouble());
  }

  /** Returns a random point in the cube [-size, size]³. */
  static Vec3 point(Random random, double size) {
    return new Vec3(
        size * (2 * random.nextDouble() - 1),
        size * (2 * random.nextDouble() - 1),
        size * (2 * random.nextDouble() - 1));
  }

  static Transform rotation(Random random) {
    return Transform.rotationDegrees(point(random, 180));
  }

  /**
   * Returns a random translation · rotation · scale; the scale factors differ by at most the given
   * ratio.
   */
  static Transform placement(Random random, double distance, double ratio) {
    Vec3 scale = new Vec3(factor(random, ratio), factor(random, ratio), factor(random, ratio));
    return Transform.translation(point(random, distance))
        .times(rotation(random))
        .times(Transform.scale(scale));
  }

  private static double factor(Random random, double ratio) {
    return StrictMath.pow(ratio, random.nextDouble() - .5);
  }

  /** Returns the nearest hit of a single shape. */
  static Optional<SurfaceHit> hit(Shape shape, Ray ray) {
    NearestHit nearest = new NearestHit();
    nearest.aim(ray);
    return shape.intersect(nearest) ? Optional.of(shape.surfaceAt(nearest)) : Optional.empty();
  }

  /** Returns the t of the nearest hit of a single shape, or NaN. */
  static double distance(Shape shape, Ray ray) {
    NearestHit nearest = new NearestHit();
    nearest.aim(ray);
    return shape.intersect(nearest) ? nearest.t : Double.NaN;
  }

  /** Returns whether a shape occludes one of its own points as seen from a surface. */
  static boolean hidesItself(Shape shape, SurfaceHit from, SurfaceSample sample) {
    NearestHit nearest = new NearestHit();
    from.spawnTowards(sample, nearest);
    return shape.intersect(nearest);
  }

  /** Tests every shape in order; the first one wins ties. */
  static boolean bruteForce(List<? extends Shape> shapes, Ray ray, NearestHit nearest) {
    nearest.aim(ray);
    for (int i = 0; i < shapes.size(); i++) {
      if (shapes.get(i).intersect(nearest)) {
        nearest.shape = i;
      }
    }
    return nearest.isHit();
  }

  static TriangleMesh triangle(Vec3 a, Vec3 b, Vec3 c) {
    double[] positions = {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()};
    return TriangleMesh.of(positions, new double[0], new double[0], new int[] {0, 1, 2});
  }

  /** Returns each triangle of a mesh as a separate mesh in world space. */
  static List<Mesh> singly(Mesh mesh) {
    TriangleMesh all = mesh.triangles();
    List<Mesh> result = new ArrayList<>();
    for (int i = 0; i < all.triangleCount(); i++) {
      TriangleMesh one =
          triangle(
              all.position(all.vertex(i, 0)),
              all.position(all.vertex(i, 1)),
              all.position(all.vertex(i, 2)));
      result.add(Mesh.baked(one, Transform.IDENTITY));
    }
    return result;
  }

  /** Returns a closed sphere-like mesh of jittered radius around the origin. */
  static TriangleMesh closedBall(int rings, int sectors, double jitter, boolean withNormals) {
    Random random = new Random(5);
    int count = (rings - 1) * sectors + 2;
    double[] p = new double[3 * count];
    double[] n = withNormals ? new double[3 * count] : new double[0];
    double[] uv = new double[2 * count];
    for (int i = 0; i < count; i++) {
      int ring = i == 0 ? 0 : i == count - 1 ? rings : 1 + (i - 1) / sectors;
      int sector = i == 0 || i == count - 1 ? 0 : (i - 1) % sectors;
      double theta = Math.PI * ring / rings;
      double phi = 2 * Math.PI * sector / sectors;
      double r = 1 + jitter * (random.nextDouble() - .5);
      double[] d = {
        StrictMath.sin(theta) * StrictMath.cos(phi),
        StrictMath.cos(theta),
        StrictMath.sin(theta) * StrictMath.sin(phi)
      };
      for (int axis = 0; axis < 3; axis++) {
        p[3 * i + axis] = r * d[axis];
        if (withNormals) {
          n[3 * i + axis] = d[axis];
        }
      }
      uv[2 * i] = (double) sector / sectors;
      uv[2 * i + 1] = (double) ring / rings;
    }
    List<Integer> f = new ArrayList<>();
    for (int ring = 0; ring < rings; ring++) {
      for (int s = 0; s < sectors; s++) {
        int a = vertex(ring, s, rings, sectors);
        int b = vertex(ring, s + 1, rings, sectors);
        int c = vertex(ring + 1, s, rings, sectors);
        int d = vertex(ring + 1, s + 1, rings, sectors);
        if (ring > 0) {
          f.addAll(List.of(a, b, c));
        }
        if (ring < rings - 1) {
          f.addAll(List.of(b, d, c));
        }
      }
    }
    return TriangleMesh.of(p, n, uv, f.stream().mapToInt(Integer::intValue).toArray());
  }

  private static int vertex(int ring, int sector, int rings, int sectors) {
    if (ring == 0) {
      return 0;
    }
    return ring == rings ? (rings - 1) * sectors + 1 : 1 + (ring - 1) * sectors + sector % sectors;
  }

  /** Returns random shapes of all kinds around the origin. */
  static List<Shape> zoo(Random random, int count) {
    SharedMesh ball = new SharedMesh(closedBall(6, 8, .2, true));
    List<Shape> shapes = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Transform place = placement(random, 5, 4);
      shapes.add(
          switch (i % 7) {
            case 0 -> new Sphere(place, .5);
            case 1 -> new Rectangle(place, 1, 2, i % 2 == 0);
            case 2 -> new Box(place, 1, .5, .7);
            case 3 -> Mesh.baked(ball.mesh(), place);
            case 4 -> new MeshInstance(ball, place);
            case 5 -> Mesh.baked(triangle(Vec3.X, Vec3.Y, Vec3.Z), place);
            default -> i == 6 ? new Plane(place, false) : new Sphere(place, .1);
          });
    }
    return shapes;
  }

  /** Returns a random ray: from inside, towards the center, or along an axis. */
  static Ray ray(Random random, Bounds3 around) {
    Vec3 target = within(random, around);
    return switch (random.nextInt(4)) {
      case 0 -> new Ray(within(random, around), direction(random));
      case 1 -> {
        Vec3 origin = around.center().plus(3 * around.radius(), direction(random));
        yield new Ray(origin, target.minus(origin).normalized());
      }
      case 2 -> {
        Vec3 axis = new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}[random.nextInt(3)];
        yield new Ray(target, random.nextBoolean() ? axis : axis.negated());
      }
      default -> {
        Vec3 origin = within(random, around);
        yield new Ray(origin, target.minus(origin), 1);
      }
    };
  }

  private static Vec3 within(Random random, Bounds3 box) {
    Vec3 u = point(random, .5).plus(new Vec3(.5, .5, .5));
    Vec3 size = box.max().minus(box.min());
    return box.min().plus(new Vec3(u.x() * size.x(), u.y() * size.y(), u.z() * size.z()));
  }
}
