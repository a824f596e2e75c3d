package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Tally;
import java.util.Arrays;

/**
 * Divides polygons in space, which may be concave and have holes, into triangles between their
 * corners. Convex polygons become fans of their first corner. Mutable: a polygon is given by {@link
 * #begin}, the {@linkplain #add corners} of each {@linkplain #endLoop loop}, the outer one first,
 * and {@link #finish}.
 */
final class PolygonDivision {
  private static final double[] EMPTY = {};

  /** Where the triangles go, and the positions come from. */
  interface Target {
    /**
     * Stores the three coordinates of a corner.
     *
     * @return false if it has none, or they are not finite
     */
    boolean position(int corner, double[] target, int at);

    void triangle(int a, int b, int c) throws ModelFormatException;
  }

  private final Tally tally;
  private final EarClipping ears;
  private Target target;
  private String location = "";
  private int[] corners = new int[16];
  private double[] positions = EMPTY;
  private int count;
  private int[] ends = new int[4];
  private int loops;
  private boolean isBroken;

  PolygonDivision(Tally tally) {
    this.tally = tally;
    ears = new EarClipping();
  }

  /**
   * Sets where the triangles go.
   *
   * @param place of the polygons in the file, for warnings
   */
  void to(Target newTarget, String place) {
    target = newTarget;
    location = place;
  }

  void triangle(int a, int b, int c) throws ModelFormatException {
    target.triangle(a, b, c);
  }

  void begin() {
    count = 0;
    loops = 0;
    isBroken = false;
  }

  void add(int corner) {
    if (count == corners.length) {
      corners = Arrays.copyOf(corners, Math.multiplyExact(2, count));
    }
    corners[count++] = corner;
  }

  /** Ends a loop; one of fewer than three corners is left out. */
  void endLoop() {
    int start = loops == 0 ? 0 : ends[loops - 1];
    if (count - start < 3) {
      tally.add(Tally.NARROW, location);
      count = start;
      isBroken |= loops == 0;
      return;
    }
    if (loops == ends.length) {
      ends = Arrays.copyOf(ends, 2 * loops);
    }
    ends[loops++] = count;
  }

  /** Adds the triangles of the polygon to the target. */
  void finish() throws ModelFormatException {
    if (isBroken) {
      return;
    }
    if (count == 3) {
      target.triangle(corners[0], corners[1], corners[2]);
      return;
    }
    if (!readPositions()) {
      return;
    }
    int outer = ends[0];
    Projection projection = Projection.of(positions, outer, count);
    boolean isFan = loops == 1 && projection.isConvex();
    if (isFan || !ears.divide(projection, Arrays.copyOf(ends, loops))) {
      if (!isFan) {
        tally.add("divided polygons of too many corners into fans, without holes", location);
      }
      for (int k = 2; k < outer; k++) {
        target.triangle(corners[0], corners[k - 1], corners[k]);
      }
      return;
    }
    for (int k = 0; k < ears.lostHoles(); k++) {
      tally.add("left out holes that are not inside their polygons", location);
    }
    for (int k = 0; k < ears.triangles().length; k += 3) {
      int[] t = ears.triangles();
      target.triangle(corners[t[k]], corners[t[k + 1]], corners[t[k + 2]]);
    }
  }

  private boolean readPositions() {
    if (positions.length < 3 * count) {
      positions = new double[Math.multiplyExact(3, corners.length)];
    }
    for (int i = 0; i < count; i++) {
      if (!target.position(corners[i], positions, 3 * i)) {
        return false;
      }
    }
    return true;
  }

  /** A polygon in the plane that it lies in most, turning left. */
  static final class Projection {
    final double[] x;
    final double[] y;
    private final int outer;

    private Projection(double[] x, double[] y, int outer) {
      this.x = x;
      this.y = y;
      this.outer = outer;
    }

    /**
     * @param outer the number of corners of the outer loop
     * @param count the number of all corners
     */
    static Projection of(double[] positions, int outer, int count) {
      double[] near = normalized(positions, count);
      double[] normal = new double[3];
      for (int i = 0; i < outer; i++) {
        int j = 3 * ((i + 1) % outer);
        for (int axis = 0; axis < 3; axis++) {
          int u = (axis + 1) % 3;
          int v = (axis + 2) % 3;
          // Newell's sum: twice the area as seen along each axis.
          normal[axis] += (near[3 * i + u] - near[j + u]) * (near[3 * i + v] + near[j + v]);
        }
      }
      int axis = 0;
      for (int i = 1; i < 3; i++) {
        axis = Math.abs(normal[i]) > Math.abs(normal[axis]) ? i : axis;
      }
      int u = (axis + (normal[axis] < 0 ? 2 : 1)) % 3;
      int v = 3 - axis - u;
      double[] x = new double[count];
      double[] y = new double[count];
      for (int i = 0; i < count; i++) {
        x[i] = near[3 * i + u];
        y[i] = near[3 * i + v];
      }
      return new Projection(x, y, outer);
    }

    /** Returns the positions relative to the first one, in units of the polygon's size. */
    private static double[] normalized(double[] positions, int count) {
      double[] near = new double[3 * count];
      double size = 0;
      for (int i = 0; i < near.length; i++) {
        near[i] = positions[i] - positions[i % 3];
        size = Math.max(size, Math.abs(near[i]));
      }
      for (int i = 0; i < near.length && size > 0; i++) {
        near[i] /= size;
      }
      return near;
    }

    /** Returns whether the outer loop turns left at all corners, once around. */
    boolean isConvex() {
      int turns = 0;
      double last = 0;
      for (int i = 0; i < outer; i++) {
        int j = (i + 1) % outer;
        if (turn(i, j, (i + 2) % outer) < -1e-12) {
          return false;
        }
        double dx = x[j] - x[i];
        turns += dx * last < 0 ? 1 : 0;
        last = dx == 0 ? last : dx;
      }
      return turns <= 2;
    }

    /** Returns a positive number if c is left of the way from a to b. */
    double turn(int a, int b, int c) {
      return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }

    boolean isSame(int a, int b) {
      return x[a] == x[b] && y[a] == y[b];
    }
  }
}
