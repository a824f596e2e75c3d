package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Chooses how large points are shown: with half the median distance of a point to the nearest other
 * one, so that most spheres of a surface's points touch each other. The median is that of some
 * points, evenly spread over the file. Stateless.
 */
final class PointSpacing {
  private static final int MOST_QUERIES = 100;
  private static final int FEWEST_QUERIES = 9;

  /** About as many distances are computed: less than two seconds of one thread. */
  private static final long DISTANCES = 1 << 30;

  private PointSpacing() {}

  /**
   * Returns the radius of a model's points, in the model's world space. If no two points differ,
   * other vertices count, too; without any, the radius is 1.
   */
  static double radius(Model model) {
    List<ModelPart> points =
        model.parts().stream().filter(part -> part.geometry().isPoints()).toList();
    if (points.isEmpty()) {
      return 1;
    }
    double[] queries = queries(points);
    OptionalDouble median = median(queries, points);
    return .5 * (median.isPresent() ? median : median(queries, model.parts())).orElse(2);
  }

  private static double[] queries(List<ModelPart> parts) {
    long total = parts.stream().mapToLong(part -> part.geometry().vertexCount()).sum();
    long affordable = Math.max(FEWEST_QUERIES, Math.min(DISTANCES / total, MOST_QUERIES));
    int count = (int) Math.min(total, affordable);
    double[] queries = new double[3 * count];
    long before = 0;
    int query = 0;
    for (ModelPart part : parts) {
      int vertices = part.geometry().vertexCount();
      for (; query < count && query * total / count < before + vertices; query++) {
        store(part, (int) (query * total / count - before), queries, 3 * query);
      }
      before += vertices;
    }
    return queries;
  }

  /** Stores the position of a vertex in the model's world space. */
  private static void store(ModelPart part, int vertex, double[] target, int to) {
    double[] positions = part.geometry().positions();
    int at = 3 * vertex;
    Transform toWorld = part.toWorld();
    Vec3 p = toWorld.point(new Vec3(positions[at], positions[at + 1], positions[at + 2]));
    target[to] = p.x();
    target[to + 1] = p.y();
    target[to + 2] = p.z();
  }

  /**
   * Returns the median distance of some points to the nearest vertex elsewhere, if there is one.
   */
  private static OptionalDouble median(double[] queries, List<ModelPart> parts) {
    double[] nearest = new double[queries.length / 3];
    Arrays.fill(nearest, Double.POSITIVE_INFINITY);
    double[] point = new double[3];
    for (ModelPart part : parts) {
      for (int i = 0; i < part.geometry().vertexCount(); i++) {
        if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
          Interrupts.check();
        }
        store(part, i, point, 0);
        approach(nearest, queries, point[0], point[1], point[2]);
      }
    }
    double[] found = Arrays.stream(nearest).filter(Double::isFinite).sorted().toArray();
    return found.length == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(Math.sqrt(found[(found.length - 1) / 2]));
  }

  /** Lowers the squared distances to a point; distances of 0 do not count. */
  private static void approach(double[] nearest, double[] queries, double x, double y, double z) {
    for (int i = 0; i < nearest.length; i++) {
      double dx = queries[3 * i] - x;
      double dy = queries[3 * i + 1] - y;
      double dz = queries[3 * i + 2] - z;
      double squared = dx * dx + dy * dy + dz * dz;
      if (squared < nearest[i] && squared > 0) {
        nearest[i] = squared;
      }
    }
  }
}
