package generator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Unwraps a mesh: connected triangles of one region that face roughly the same way form a chart,
 * which is projected along the nearest axis, and the charts are packed into a square.
 */
final class Atlas {
  private static final Vec[] AXES = {
    new Vec(1, 0, 0), new Vec(-1, 0, 0), new Vec(0, 1, 0),
    new Vec(0, -1, 0), new Vec(0, 0, 1), new Vec(0, 0, -1)
  };
  private static final double LEAST_COSINE = .25;
  private static final int SMALL = 24;
  private static final int ROUNDS = 6;
  private static final int PADDING = 3;

  private final Mesh mesh;
  private final Vec[] normals;
  private final int[][] adjacent;
  private final int[] facing;
  private final int[] region;
  private int[] chart;
  private int charts;

  /** For each corner of each triangle, u and v in [0, 1]. */
  final double[] uv;

  Atlas(Mesh mesh, Sculpture sculpture, int size) {
    this.mesh = mesh;
    int n = mesh.triangleCount();
    normals = new Vec[n];
    facing = new int[n];
    region = new int[n];
    for (int t = 0; t < n; t++) {
      normals[t] = mesh.areaVector(t).normalized();
      facing[t] = widest(t);
      Vec sum = mesh.corner(t, 0).plus(mesh.corner(t, 1)).plus(mesh.corner(t, 2));
      region[t] = sculpture.region(sum.times(1 / 3.0));
    }
    adjacent = adjacency();
    findCharts();
    for (int round = 0; round < ROUNDS; round++) {
      smooth();
      mergeSmall();
    }
    uv = pack(size);
  }

  private int widest(int t) {
    int best = 0;
    for (int a = 1; a < 6; a++) {
      best = normals[t].dot(AXES[a]) > normals[t].dot(AXES[best]) + 1e-9 ? a : best;
    }
    return best;
  }

  private int[][] adjacency() {
    Map<Long, List<Integer>> edges = new HashMap<>();
    int n = mesh.triangleCount();
    for (int t = 0; t < n; t++) {
      for (int c = 0; c < 3; c++) {
        edges.computeIfAbsent(edge(t, c), k -> new ArrayList<>(2)).add(t);
      }
    }
    int[][] result = new int[n][];
    for (int t = 0; t < n; t++) {
      List<Integer> near = new ArrayList<>();
      for (int c = 0; c < 3; c++) {
        for (int o : edges.get(edge(t, c))) {
          if (o != t) {
            near.add(o);
          }
        }
      }
      result[t] = near.stream().mapToInt(Integer::intValue).toArray();
    }
    return result;
  }

  private long edge(int t, int c) {
    long a = mesh.triangles()[3 * t + c];
    long b = mesh.triangles()[3 * t + (c + 1) % 3];
    return Math.min(a, b) << 32 | Math.max(a, b);
  }

  /** Gives a triangle the direction that most of its neighbours have. */
  private void smooth() {
    for (int t = 0; t < facing.length; t++) {
      int[] votes = new int[6];
      for (int o : adjacent[t]) {
        votes[facing[o]]++;
      }
      for (int a = 0; a < 6; a++) {
        if (votes[a] >= 2 && normals[t].dot(AXES[a]) > LEAST_COSINE) {
          facing[t] = a;
        }
      }
    }
    findCharts();
  }

  private void findCharts() {
    chart = new int[facing.length];
    Arrays.fill(chart, -1);
    charts = 0;
    ArrayDeque<Integer> open = new ArrayDeque<>();
    for (int start = 0; start < facing.length; start++) {
      if (chart[start] >= 0) {
        continue;
      }
      chart[start] = charts;
      open.add(start);
      while (!open.isEmpty()) {
        int t = open.remove();
        for (int o : adjacent[t]) {
          if (chart[o] < 0 && facing[o] == facing[start] && region[o] == region[start]) {
            chart[o] = charts;
            open.add(o);
          }
        }
      }
      charts++;
    }
  }

  /** Lets the triangles of small charts join a neighbour that faces nearly as they do. */
  private void mergeSmall() {
    int[] sizes = new int[charts];
    for (int c : chart) {
      sizes[c]++;
    }
    for (int t = 0; t < facing.length; t++) {
      if (sizes[chart[t]] >= SMALL) {
        continue;
      }
      double best = LEAST_COSINE;
      for (int o : adjacent[t]) {
        double cosine = normals[t].dot(AXES[facing[o]]);
        if (sizes[chart[o]] > sizes[chart[t]] && cosine > best) {
          best = cosine;
          facing[t] = facing[o];
        }
      }
    }
    findCharts();
  }

  /** One chart's rectangle, in units of length until it is placed in texels. */
  private static final class Box {
    double minU = 1e9;
    double minV = 1e9;
    double maxU = -1e9;
    double maxV = -1e9;
    int x;
    int y;

    int width(double scale) {
      return (int) Math.ceil((maxU - minU) * scale) + 2 * PADDING;
    }

    int height(double scale) {
      return (int) Math.ceil((maxV - minV) * scale) + 2 * PADDING;
    }
  }

  private double[] pack(int size) {
    Box[] boxes = new Box[charts];
    Arrays.setAll(boxes, i -> new Box());
    double[] projected = new double[mesh.triangles().length * 2];
    for (int i = 0; i < mesh.triangles().length; i++) {
      Vec p = mesh.positions()[mesh.triangles()[i]];
      int axis = facing[i / 3];
      double u = axis < 2 ? (axis == 0 ? p.z() : -p.z()) : axis == 4 ? -p.x() : p.x();
      double v = axis == 2 ? p.z() : axis == 3 ? -p.z() : p.y();
      projected[2 * i] = u;
      projected[2 * i + 1] = v;
      Box box = boxes[chart[i / 3]];
      box.minU = Math.min(box.minU, u);
      box.minV = Math.min(box.minV, v);
      box.maxU = Math.max(box.maxU, u);
      box.maxV = Math.max(box.maxV, v);
    }
    double scale = largestScale(boxes, size);
    double[] result = new double[projected.length];
    for (int i = 0; i < projected.length; i += 2) {
      Box box = boxes[chart[i / 6]];
      result[i] = (box.x + PADDING + (projected[i] - box.minU) * scale) / size;
      result[i + 1] = (box.y + PADDING + (projected[i + 1] - box.minV) * scale) / size;
    }
    return result;
  }

  private static double largestScale(Box[] boxes, int size) {
    double low = 1;
    double high = 100000;
    for (int i = 0; i < 40; i++) {
      double middle = (low + high) / 2;
      if (place(boxes, size, middle)) {
        low = middle;
      } else {
        high = middle;
      }
    }
    place(boxes, size, low);
    return low;
  }

  /** Sets each box down as low as the boxes before it allow; false if one sticks out. */
  private static boolean place(Box[] boxes, int size, double scale) {
    Box[] sorted = boxes.clone();
    Arrays.sort(sorted, Comparator.comparingInt((Box b) -> -b.height(scale)));
    int[] skyline = new int[size];
    for (Box box : sorted) {
      int w = box.width(scale);
      int best = Integer.MAX_VALUE;
      for (int x = 0; x + w <= size; x++) {
        int top = 0;
        for (int i = x; i < x + w && top < best; i++) {
          top = Math.max(top, skyline[i]);
        }
        if (top < best) {
          best = top;
          box.x = x;
        }
      }
      if (best == Integer.MAX_VALUE || best + box.height(scale) > size) {
        return false;
      }
      box.y = best;
      Arrays.fill(skyline, box.x, box.x + w, best + box.height(scale));
    }
    return true;
  }
}
