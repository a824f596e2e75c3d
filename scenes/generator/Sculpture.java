package generator;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;

/** A figure put together from solid bodies that may overlap. Mutable while it is built. */
final class Sculpture {
  private static final double NORMAL_STEP = .0015;

  private final List<Body> bodies = new ArrayList<>();
  private final double hidden;
  private final ToIntFunction<Vec> regions;

  /**
   * @param hidden how deep within another body a triangle must lie to be left out
   * @param regions numbers the regions that the texture keeps apart, such as the limbs of one body
   */
  Sculpture(double hidden, ToIntFunction<Vec> regions) {
    this.hidden = hidden;
    this.regions = regions;
  }

  void add(double cell, Sdf shape, Paint paint) {
    bodies.add(new Body(shape, paint, cell));
  }

  /** Adds a body and its mirror image in the plane x = 0. */
  void addPair(double cell, Sdf shape, Paint paint) {
    Body body = new Body(shape, paint, cell);
    bodies.add(body);
    bodies.add(body.mirrored());
  }

  Paint paint(int body) {
    return bodies.get(body).paint();
  }

  /** The region of the texture that a point belongs to. */
  int region(Vec p) {
    return regions.applyAsInt(p);
  }

  /** The outward unit normal of a body at a point of its surface. */
  Vec normal(int body, Vec p) {
    return bodies.get(body).shape().normal(p, NORMAL_STEP);
  }

  /** The visible surface of all bodies, with about this many triangles. */
  Mesh mesh(int triangles) {
    List<Vec> positions = new ArrayList<>();
    List<Integer> owners = new ArrayList<>();
    List<Integer> corners = new ArrayList<>();
    for (int b = 0; b < bodies.size(); b++) {
      Mesh part = Mesher.mesh(bodies.get(b).shape(), bodies.get(b).cell());
      boolean[] covered = covered(b, part);
      int base = positions.size();
      for (Vec p : part.positions()) {
        positions.add(p);
        owners.add(b);
      }
      for (int t = 0; t < part.triangleCount(); t++) {
        int[] v = part.triangles();
        if (!(covered[v[3 * t]] && covered[v[3 * t + 1]] && covered[v[3 * t + 2]])) {
          for (int c = 0; c < 3; c++) {
            corners.add(base + v[3 * t + c]);
          }
        }
      }
    }
    Mesh fine =
        new Mesh(
            positions.toArray(new Vec[0]),
            corners.stream().mapToInt(Integer::intValue).toArray(),
            owners.stream().mapToInt(Integer::intValue).toArray());
    return settle(Decimator.decimate(fine, triangles));
  }

  private boolean[] covered(int body, Mesh part) {
    boolean[] covered = new boolean[part.positions().length];
    for (int v = 0; v < covered.length; v++) {
      for (int o = 0; o < bodies.size() && !covered[v]; o++) {
        covered[v] = o != body && bodies.get(o).shape().at(part.positions()[v]) < -hidden;
      }
    }
    return covered;
  }

  /** Moves the vertices back onto the surface. */
  private Mesh settle(Mesh mesh) {
    Vec[] settled = mesh.positions().clone();
    for (int v = 0; v < settled.length; v++) {
      Body body = bodies.get(mesh.bodies()[v]);
      settled[v] = Mesher.project(body.shape(), settled[v], NORMAL_STEP, body.cell() / 3);
    }
    return new Mesh(settled, mesh.triangles(), mesh.bodies());
  }
}
