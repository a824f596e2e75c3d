package io.github.lumbre.stage.drawing;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.section.Hatch;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The lines of a {@link Hatch} on a flat cut surface: their ends in world space. Immutable.
 *
 * @param ends start and end of each line
 * @param across from a line to the next one, in the middle of the surface
 */
record Hatching(List<Vec3[]> ends, Vec3 across) {
  /** Gaps between triangles below this part of a surface are rounding. */
  private static final double ROUNDING = 1e-6;

  /** More lines than these are no hatch that can be seen. */
  private static final double MOST_LINES = 100_000;

  /** The map from the plane of a surface to world space. */
  private record Plane(Vec3 origin, Vec3 u, Vec3 v) {
    /** Returns the plane by the largest triangle; empty if all are slivers. */
    static Optional<Plane> of(TriangleMesh mesh) {
      Optional<Plane> best = Optional.empty();
      double most = 0;
      for (int i = 0; i < mesh.triangleCount(); i++) {
        double[] a = uv(mesh, i, 0);
        double[] b = uv(mesh, i, 1);
        double[] c = uv(mesh, i, 2);
        double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if (Math.abs(area) > most) {
          most = Math.abs(area);
          Vec3 at = mesh.position(mesh.vertex(i, 0));
          Vec3 toB = mesh.position(mesh.vertex(i, 1)).minus(at);
          Vec3 toC = mesh.position(mesh.vertex(i, 2)).minus(at);
          Vec3 u = toB.times((c[1] - a[1]) / area).plus(-(b[1] - a[1]) / area, toC);
          Vec3 v = toC.times((b[0] - a[0]) / area).plus(-(c[0] - a[0]) / area, toB);
          best = Optional.of(new Plane(at.plus(-a[0], u).plus(-a[1], v), u, v));
        }
      }
      return best;
    }

    Vec3 at(double[] uv) {
      return origin.plus(uv[0], u).plus(uv[1], v);
    }
  }

  /** Returns the lines on a mesh whose texture coordinates are those of its plane. */
  static Optional<Hatching> of(TriangleMesh mesh, Hatch hatch) {
    TreeMap<Long, List<double[]>> ranges = new TreeMap<>();
    for (int i = 0; i < mesh.triangleCount(); i++) {
      addRanges(mesh, i, hatch, ranges);
    }
    return Plane.of(mesh).map(plane -> of(ranges, hatch, plane));
  }

  private static Hatching of(TreeMap<Long, List<double[]>> ranges, Hatch hatch, Plane plane) {
    double square = hatch.across() * hatch.across() + hatch.upwards() * hatch.upwards();
    List<Vec3[]> ends = new ArrayList<>();
    ranges.forEach(
        (line, parts) -> {
          double level = line + .5 * Hatch.WIDTH;
          for (double[] range : joined(parts)) {
            Vec3[] of = new Vec3[2];
            Arrays.setAll(of, end -> plane.at(uv(level, range[end], hatch, square)));
            ends.add(of);
          }
        });
    Vec3 across =
        plane.u.times(hatch.across() / square).plus(hatch.upwards() / square, plane.v);
    return new Hatching(ends, across);
  }

  /** Returns the texture coordinates of a place along a line. */
  private static double[] uv(double level, double along, Hatch hatch, double square) {
    return new double[] {
      (level * hatch.across() - along * hatch.upwards()) / square,
      (level * hatch.upwards() + along * hatch.across()) / square
    };
  }

  private static double[] uv(TriangleMesh mesh, int triangle, int corner) {
    TexturePoint point = mesh.uv(triangle, corner);
    return new double[] {point.u(), point.v()};
  }

  /** Adds the ranges in which lines cross a triangle, by the numbers of the lines. */
  private static void addRanges(
      TriangleMesh mesh, int triangle, Hatch hatch, TreeMap<Long, List<double[]>> ranges) {
    double[] across = new double[3];
    double[] along = new double[3];
    for (int corner = 0; corner < 3; corner++) {
      double[] uv = uv(mesh, triangle, corner);
      across[corner] = uv[0] * hatch.across() + uv[1] * hatch.upwards() - .5 * Hatch.WIDTH;
      along[corner] = uv[1] * hatch.across() - uv[0] * hatch.upwards();
    }
    double first = Math.ceil(Arrays.stream(across).min().orElseThrow());
    double last = Math.floor(Arrays.stream(across).max().orElseThrow());
    if (!(last - first < MOST_LINES)) {
      return;
    }
    for (double line = first; line <= last; line++) {
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (int corner = 0; corner < 3; corner++) {
        int next = (corner + 1) % 3;
        double share = (line - across[corner]) / (across[next] - across[corner]);
        if (share >= 0 && share <= 1) {
          double place = along[corner] + share * (along[next] - along[corner]);
          low = Math.min(low, place);
          high = Math.max(high, place);
        }
      }
      if (high > low) {
        ranges.computeIfAbsent((long) line, l -> new ArrayList<>()).add(new double[] {low, high});
      }
    }
  }

  /** Joins ranges that touch. */
  private static List<double[]> joined(List<double[]> ranges) {
    ranges.sort(Comparator.comparingDouble(range -> range[0]));
    double reach = ranges.get(ranges.size() - 1)[1] - ranges.get(0)[0];
    List<double[]> joined = new ArrayList<>();
    for (double[] range : ranges) {
      double[] before = joined.isEmpty() ? null : joined.get(joined.size() - 1);
      if (before != null && range[0] <= before[1] + ROUNDING * reach) {
        before[1] = Math.max(before[1], range[1]);
      } else {
        joined.add(range.clone());
      }
    }
    return joined;
  }
}
