package generator;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Turns a solid into triangles by surface nets: one vertex for each cell of a grid that the surface
 * crosses, moved onto the surface, and one quadrilateral for each grid edge that it crosses
 * (Gibson, "Constrained Elastic Surface Nets", 1998).
 */
final class Mesher {
  private static final int BLOCK = 8;
  private static final int LEVELS = 7;
  private static final int OFFSET = BLOCK << LEVELS - 1;
  private static final double SAFETY = 1.5;

  private final Sdf shape;
  private final double cell;
  private final List<Vec> vertices = new ArrayList<>();
  private final List<int[]> cells = new ArrayList<>();
  private final Map<Long, Integer> vertexOfCell = new HashMap<>();

  private Mesher(Sdf shape, double cell) {
    this.shape = shape;
    this.cell = cell;
  }

  /** The surface of a solid that lies within 512 cells of the origin; every vertex has body 0. */
  static Mesh mesh(Sdf shape, double cell) {
    Mesher mesher = new Mesher(shape, cell);
    mesher.descend(-OFFSET, -OFFSET, -OFFSET, 2 * OFFSET);
    return mesher.connect();
  }

  /** Visits the blocks that the surface may cross. */
  private void descend(int x, int y, int z, int size) {
    double half = size * cell / 2;
    double distance = shape.at(x * cell + half, y * cell + half, z * cell + half);
    if (Math.abs(distance) > SAFETY * half * Math.sqrt(3)) {
      return;
    }
    if (size == BLOCK) {
      block(x, y, z);
      return;
    }
    int h = size / 2;
    for (int c = 0; c < 8; c++) {
      descend(x + (c & 1) * h, y + (c >> 1 & 1) * h, z + (c >> 2) * h, h);
    }
  }

  /** Places the vertices of one block's cells. */
  private void block(int x0, int y0, int z0) {
    int n = BLOCK + 1;
    double[] values = new double[n * n * n];
    for (int k = 0; k < n; k++) {
      for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
          values[(k * n + j) * n + i] = shape.at((x0 + i) * cell, (y0 + j) * cell, (z0 + k) * cell);
        }
      }
    }
    double[] corners = new double[8];
    for (int k = 0; k < BLOCK; k++) {
      for (int j = 0; j < BLOCK; j++) {
        for (int i = 0; i < BLOCK; i++) {
          for (int c = 0; c < 8; c++) {
            corners[c] = values[((k + (c >> 2)) * n + j + (c >> 1 & 1)) * n + i + (c & 1)];
          }
          cell(x0 + i, y0 + j, z0 + k, corners);
        }
      }
    }
  }

  private void cell(int x, int y, int z, double[] corners) {
    int inside = 0;
    for (int c = 0; c < 8; c++) {
      inside |= corners[c] < 0 ? 1 << c : 0;
    }
    if (inside == 0 || inside == 255) {
      return;
    }
    Vec sum = new Vec(0, 0, 0);
    int count = 0;
    for (int a = 0; a < 8; a++) {
      for (int axis = 1; axis < 8; axis <<= 1) {
        int b = a | axis;
        if (a == b || (inside >> a & 1) == (inside >> b & 1)) {
          continue;
        }
        double t = corners[a] / (corners[a] - corners[b]);
        sum = sum.plus(offset(a).lerp(offset(b), t));
        count++;
      }
    }
    Vec start = new Vec(x, y, z).plus(sum.times(1.0 / count)).times(cell);
    vertexOfCell.put(key(x, y, z), vertices.size());
    vertices.add(project(shape, start, cell / 4, cell));
    cells.add(new int[] {x, y, z, inside});
  }

  private static Vec offset(int corner) {
    return new Vec(corner & 1, corner >> 1 & 1, corner >> 2);
  }

  private static long key(int x, int y, int z) {
    return ((long) (x + OFFSET) << 42) | ((long) (y + OFFSET) << 21) | (z + OFFSET);
  }

  /** A point of the surface near {@code p}, or {@code p} itself where there is none. */
  static Vec project(Sdf shape, Vec p, double step, double limit) {
    Vec q = p;
    for (int i = 0; i < 4; i++) {
      double distance = shape.at(q);
      Vec g = shape.gradient(q, step);
      q = q.minus(g.times(distance / Math.max(.05, g.dot(g))));
    }
    boolean better = q.minus(p).length() < limit && Math.abs(shape.at(q)) < Math.abs(shape.at(p));
    return better ? q : p;
  }

  /** Joins the cells around each crossed grid edge. */
  private Mesh connect() {
    int[] triangles = new int[18 * cells.size()];
    int used = 0;
    for (int[] c : cells) {
      for (int axis = 0; axis < 3; axis++) {
        boolean first = (c[3] & 1) != 0;
        if (first == ((c[3] >> (1 << axis) & 1) != 0)) {
          continue;
        }
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        int[] quad = {
          vertex(c, u, 0, v, 0), vertex(c, u, 1, v, 0), vertex(c, u, 1, v, 1), vertex(c, u, 0, v, 1)
        };
        int[] order = first ? new int[] {0, 1, 2, 0, 2, 3} : new int[] {0, 2, 1, 0, 3, 2};
        for (int corner : order) {
          triangles[used++] = quad[corner];
        }
      }
    }
    Vec[] positions = vertices.toArray(new Vec[0]);
    return new Mesh(positions, Arrays.copyOf(triangles, used), new int[positions.length]);
  }

  private int vertex(int[] cell, int u, int du, int v, int dv) {
    int[] at = cell.clone();
    at[u] -= du;
    at[v] -= dv;
    Integer vertex = vertexOfCell.get(key(at[0], at[1], at[2]));
    if (vertex == null) {
      throw new IllegalStateException("the surface leaves the blocks near " + vertices.get(0));
    }
    return vertex;
  }
}
