package io.github.lumbre.model.difference;

import io.github.lumbre.geometry.internal.PositionIndex;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A part of a model: its surface in the model's world space, and what identifies it. Immutable.
 *
 * @param name unique in its model, for users
 * @param stated name in the file, by which it is the same part in another file; empty for none
 * @param vertices its distinct vertices, three coordinates each; points of clouds count as vertices
 * @param triangles their number
 * @param area of the surface
 * @param edges sum of the lengths of all sides of triangles
 * @param centroid of the surface; of the vertices, if it has no area
 * @param spread root mean square distance of the surface from its centroid
 * @param bounds of the vertices
 * @param materials that the file states for the surface; empty if it states none
 * @param surfaces the meshes
 */
record PartShape(
    String name,
    String stated,
    double[] vertices,
    int triangles,
    double area,
    double edges,
    Vec3 centroid,
    double spread,
    Bounds3 bounds,
    Set<String> materials,
    List<Surface> surfaces) {
  /** Returns the node of the file that the part is; empty if it has no meshes. */
  Optional<ModelNode> node() {
    return surfaces.stream().findFirst().map(surface -> surface.part().node());
  }

  /**
   * A mesh of the part.
   *
   * @param material what the file states of its material; empty if it states none
   */
  record Surface(ModelPart part, String material) {}

  /** Sums up the surface of a part. Mutable. */
  static final class Builder {
    private final PositionIndex index = new PositionIndex();
    private final Vec3 middle;
    private int triangles;
    private double area;
    private double edges;
    private Vec3 moment = Vec3.ZERO;
    private double squares;
    private Vec3 sum = Vec3.ZERO;
    private Bounds3 bounds = Bounds3.EMPTY;
    private int points;
    private final List<Surface> surfaces = new ArrayList<>();

    /**
     * @param middle a point near the part, so that sums stay exact
     */
    Builder(Vec3 middle) {
      this.middle = middle;
    }

    void surface(Surface surface) {
      surfaces.add(surface);
    }

    private void addVertex(Vec3 p) {
      index.number(p.x(), p.y(), p.z());
      bounds = bounds.union(p);
      sum = sum.plus(p.minus(middle));
      points++;
    }

    Builder point(Vec3 p) {
      addVertex(p);
      return this;
    }

    Builder triangle(Vec3 p, Vec3 q, Vec3 r) {
      addVertex(p);
      addVertex(q);
      addVertex(r);
      Vec3 a = p.minus(middle);
      Vec3 b = q.minus(middle);
      Vec3 c = r.minus(middle);
      double size = .5 * b.minus(a).cross(c.minus(a)).length();
      triangles++;
      area += size;
      edges += b.minus(a).length() + c.minus(b).length() + a.minus(c).length();
      Vec3 corners = a.plus(b).plus(c);
      moment = moment.plus(corners.times(size / 3));
      // The mean square of a triangle: the squares of its corners, and of their sum, by 12.
      double mean = (a.dot(a) + b.dot(b) + c.dot(c) + corners.dot(corners)) / 12;
      squares += size * mean;
      return this;
    }

    PartShape build(String name, String stated, Set<String> materials) {
      Vec3 center = area > 0 ? moment.times(1 / area) : sum.times(1. / Math.max(1, points));
      double variance = area > 0 ? squares / area - center.dot(center) : 0;
      return new PartShape(
          name,
          stated,
          index.positions(),
          triangles,
          area,
          edges,
          middle.plus(center),
          Math.sqrt(Math.max(0, variance)),
          bounds,
          Set.copyOf(materials),
          surfaces);
    }
  }

  /** A part equals itself only. */
  @Override
  public boolean equals(Object other) {
    return this == other;
  }

  @Override
  public int hashCode() {
    return System.identityHashCode(this);
  }

  private Vec3 vertex(int number) {
    return new Vec3(vertices[3 * number], vertices[3 * number + 1], vertices[3 * number + 2]);
  }

  int vertexCount() {
    return vertices.length / 3;
  }

  /** Returns a vertex as an offset from the centroid. */
  Vec3 offset(int number) {
    return vertex(number).minus(centroid);
  }

  /**
   * Returns whether another surface may be this one after a motion: numbers that no motion changes
   * agree.
   *
   * @param tolerance by which vertices may differ
   */
  boolean isLike(PartShape other, double tolerance) {
    double areas = 2 * tolerance * Math.max(edges, other.edges);
    double spreads = 2 * tolerance + spread * areas / Math.max(area, Double.MIN_NORMAL);
    return Math.abs(area - other.area) <= areas
        && Math.abs(spread - other.spread) <= spreads
        && (triangles == 0) == (other.triangles == 0);
  }

  /** Returns the triangles, relative to the centroid. */
  TriangleTree tree() {
    double[] corners = new double[9 * triangles];
    int count = 0;
    for (Surface surface : surfaces) {
      for (int vertex : surface.part().geometry().indices()) {
        Vec3 p = surface.part().position(vertex).minus(centroid);
        corners[count++] = p.x();
        corners[count++] = p.y();
        corners[count++] = p.z();
      }
    }
    return new TriangleTree(corners);
  }

  /** Returns whether the file states the surface, and nothing of its look. */
  boolean isBare() {
    return surfaces.stream()
        .allMatch(
            surface -> {
              ModelGeometry mesh = surface.part().geometry();
              return surface.material().isEmpty()
                  && mesh.normals().length + mesh.uv0().length + mesh.colors().length == 0;
            });
  }

  /** Returns whether both files state materials, and other ones. */
  boolean isRecolored(PartShape other) {
    return !materials.isEmpty() && !other.materials.isEmpty() && !materials.equals(other.materials);
  }
}
