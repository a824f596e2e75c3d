package io.github.lumbre.model.difference;

import io.github.lumbre.math.Vec3;
import java.util.List;

/** Moves points to a surface, by the planes of the nearest triangles (Chen and Medioni 1992). */
final class Fit {
  /** The most steps towards the surface. */
  static final int ROUNDS = 40;

  /** Keeps directions in which nothing resists, as about the axis of a cylinder, at rest. */
  private static final double DAMPING = 1e-7;

  /** Motions below this part of the size are none. */
  private static final double STILL = 1e-9;

  private Fit() {}

  /**
   * Returns a motion near another one that moves points to a surface.
   *
   * @param size of the surface
   * @param isShift whether points are only shifted
   */
  static Rigid of(
      List<Vec3> points, Rigid start, TriangleTree surface, double size, boolean isShift) {
    Rigid rigid = start;
    TriangleTree.Nearest nearest = new TriangleTree.Nearest();
    int first = isShift ? 3 : 0;
    for (int round = 0; round < ROUNDS; round++) {
      double[][] rows = new double[6][7];
      for (Vec3 point : points) {
        Vec3 p = rigid.apply(point);
        surface.find(p, size, nearest);
        if (nearest.triangle() >= 0) {
          add(p, nearest.triangle(), surface, size, rows);
        }
      }
      double[] step = solved(rows, first);
      Vec3 rotation = new Vec3(step[0], step[1], step[2]).times(1 / size);
      Vec3 shift = new Vec3(step[3], step[4], step[5]);
      if (!rotation.isFinite() || !shift.isFinite()) {
        return rigid;
      }
      rigid = rigid.turned(rotation).shifted(shift);
      if (rotation.length() * size + shift.length() < STILL * size) {
        return rigid;
      }
    }
    return rigid;
  }

  /** Adds the equation of a point: its distance from the plane of a triangle becomes 0. */
  private static void add(
      Vec3 p, int triangle, TriangleTree surface, double size, double[]... rows) {
    Vec3 a = surface.corner(triangle, 0);
    Vec3 cross = surface.corner(triangle, 1).minus(a).cross(surface.corner(triangle, 2).minus(a));
    if (!(cross.length() > 0)) {
      return;
    }
    Vec3 n = cross.normalized();
    Vec3 turn = p.cross(n).times(1 / size);
    double[] row = {turn.x(), turn.y(), turn.z(), n.x(), n.y(), n.z(), n.dot(a.minus(p))};
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 7; j++) {
        rows[i][j] += row[i] * row[j];
      }
    }
  }

  /** Solves damped equations by elimination, from one unknown on; those before it are 0. */
  private static double[] solved(double[][] rows, int first) {
    double trace = 0;
    for (int i = first; i < 6; i++) {
      trace += rows[i][i];
    }
    for (int i = first; i < 6; i++) {
      rows[i][i] += DAMPING * trace;
    }
    for (int i = first; i < 6; i++) {
      for (int k = i + 1; k < 6; k++) {
        double factor = rows[k][i] / rows[i][i];
        for (int j = i; j < 7; j++) {
          rows[k][j] -= factor * rows[i][j];
        }
      }
    }
    double[] solution = new double[6];
    for (int i = 5; i >= first; i--) {
      double sum = rows[i][6];
      for (int j = i + 1; j < 6; j++) {
        sum -= rows[i][j] * solution[j];
      }
      solution[i] = sum / rows[i][i];
    }
    return solution;
  }

  /** Returns the mean square distance of moved points from a surface, at most that of a limit. */
  static double score(List<Vec3> points, Rigid rigid, TriangleTree surface, double limit) {
    TriangleTree.Nearest nearest = new TriangleTree.Nearest();
    double sum = 0;
    for (Vec3 point : points) {
      surface.find(rigid.apply(point), limit, nearest);
      double distance = nearest.triangle() < 0 ? limit : nearest.distance();
      sum += distance * distance;
    }
    return sum / points.size();
  }
}
