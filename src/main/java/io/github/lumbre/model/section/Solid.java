package io.github.lumbre.model.section;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelPart;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A closed shell of a body, scaled so that the body has a size of 1.
 *
 * @param shell its number
 * @param isInsideOut whether its volume is negative: its triangles face its inside
 */
record Solid(int shell, TriangleMesh triangles, boolean isInsideOut) {
  /** Volumes below this part of the sum of their terms are rounding errors. */
  private static final double NO_VOLUME = 1e-10;

  /** How far points are inside of a triangle. */
  private static final double INSIDE = 1e-7;

  /** Weights of the corners of points in triangles: no usual line leads through these points. */
  private static final double[] WEIGHTS = {.5437, .2593, .197};

  /** Receives the triangles of closed shells. */
  private interface Visitor {
    void visit(int shell, Vec3 p, Vec3 q, Vec3 r);
  }

  /** The volume of a shell. Mutable. */
  private static final class Volume {
    private final Vec3 origin;
    private double volume;
    private double terms;

    Volume(Vec3 origin) {
      this.origin = origin;
    }

    void add(Vec3 p, Vec3 q, Vec3 r) {
      double term = p.minus(origin).dot(q.minus(origin).cross(r.minus(origin)));
      volume += term;
      terms += Math.abs(term);
    }

    boolean isAny() {
      return Math.abs(volume) > NO_VOLUME * terms;
    }
  }

  /** The corners of a shell. Mutable. */
  private static final class Corners {
    private double[] positions = new double[9];
    private int size;

    void add(Vec3 p) {
      positions = size == positions.length ? Arrays.copyOf(positions, 2 * size) : positions;
      positions[size++] = p.x();
      positions[size++] = p.y();
      positions[size++] = p.z();
    }

    TriangleMesh mesh() {
      int[] indices = new int[size / 3];
      Arrays.setAll(indices, i -> i);
      double[] none = {};
      return TriangleMesh.of(Arrays.copyOf(positions, size), none, none, indices);
    }
  }

  /** Returns the closed shells of a body that have a volume; none if all face their outside. */
  static List<Solid> of(List<ModelPart> meshes, Shells shells) {
    Map<Integer, Volume> volumes = new TreeMap<>();
    visit(
        meshes,
        shells,
        (shell, p, q, r) -> volumes.computeIfAbsent(shell, s -> new Volume(p)).add(p, q, r));
    volumes.values().removeIf(volume -> !volume.isAny());
    if (volumes.values().stream().allMatch(volume -> volume.volume > 0)) {
      return List.of();
    }
    Map<Integer, Corners> corners = new TreeMap<>();
    visit(
        meshes,
        shells,
        (shell, p, q, r) -> {
          if (volumes.containsKey(shell)) {
            Corners of = corners.computeIfAbsent(shell, s -> new Corners());
            List.of(p, q, r).forEach(of::add);
          }
        });
    return corners.entrySet().stream()
        .map(e -> new Solid(e.getKey(), e.getValue().mesh(), volumes.get(e.getKey()).volume < 0))
        .toList();
  }

  private static void visit(List<ModelPart> meshes, Shells shells, Visitor visitor) {
    Bounds3 box = Bounds3.EMPTY;
    for (ModelPart mesh : meshes) {
      box = box.union(mesh.toWorld().bounds(mesh.geometry().bounds()));
    }
    Vec3 low = box.min();
    double scale = 1 / box.max().minus(low).maxAbs();
    for (int m = 0; m < meshes.size(); m++) {
      ModelPart mesh = meshes.get(m);
      int[] indices = mesh.geometry().indices();
      for (int i = 0; i < indices.length; i += 3) {
        if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
          Interrupts.check();
        }
        int shell = shells.of(m, indices[i]);
        if (shells.isClosed(shell)) {
          visitor.visit(
              shell,
              mesh.position(indices[i]).minus(low).times(scale),
              mesh.position(indices[i + 1]).minus(low).times(scale),
              mesh.position(indices[i + 2]).minus(low).times(scale));
        }
      }
    }
  }

  private Vec3 corner(int triangle, int corner) {
    return triangles.position(triangles.vertex(triangle, corner));
  }

  /** Returns a vector along the normal of a triangle whose length is twice the area. */
  Vec3 normal(int triangle) {
    Vec3 p = corner(triangle, 0);
    return corner(triangle, 1).minus(p).cross(corner(triangle, 2).minus(p));
  }

  /** Returns a point just inside of a triangle. */
  Vec3 inside(int triangle) {
    Vec3 sum = Vec3.ZERO;
    for (int k = 0; k < 3; k++) {
      sum = sum.plus(WEIGHTS[k], corner(triangle, k));
    }
    return sum.plus(isInsideOut ? INSIDE : -INSIDE, normal(triangle).normalized());
  }
}
