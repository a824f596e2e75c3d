package io.github.lumbre.model.difference;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.internal.PositionIndex;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/**
 * What the surfaces of a part state at its distinct vertices: means over the corners of triangles
 * at a vertex, by their angles. Such a mean does not depend on how a flat face is divided into
 * triangles. Weights differ by the directions of faces, so that faces cannot exchange their values
 * unnoticed. Confined to one thread.
 */
final class SurfaceValues {
  private static final int INTERRUPT_MASK = 0xffff;

  /** Triangles lower than this many tolerances have no direction. */
  private static final double LOWEST = 20;

  /** Vertices whose weights differ by more than this part have other triangles. */
  private static final double SAME_WEIGHT = .01;

  /** Parallel to no face of usual parts. */
  private static final Vec3 AXIS = new Vec3(.3, .87, .52).normalized();

  /** What is stated. */
  enum Kind {
    SIDES("triangles turned over", 3, true, .2),
    NORMALS("other normals", 3, true, .02),
    TANGENTS("other tangents", 4, true, .05),
    TEXTURE("other texture coordinates", 2, false, 1e-4),
    SECOND_TEXTURE("other second texture coordinates", 2, false, 1e-4),
    COLORS("other vertex colors", 4, false, 1. / 512),
    MATERIALS("another material on some faces", 1, false, 1e-6);

    final String change;
    private final int size;
    private final boolean isDirection;
    private final double tolerance;

    Kind(String change, int size, boolean isDirection, double tolerance) {
      this.change = change;
      this.size = size;
      this.isDirection = isDirection;
      this.tolerance = tolerance;
    }
  }

  private static final int[] FIRST = new int[Kind.values().length];
  private static final int STRIDE;

  static {
    int next = 1;
    for (Kind kind : Kind.values()) {
      FIRST[kind.ordinal()] = next;
      next += kind.size;
    }
    STRIDE = next;
  }

  private final Vec3 axis;
  private final double tolerance;
  private final PositionIndex index = new PositionIndex();

  /** The weight of each vertex, and weighted sums of values of each kind. */
  private final double[] sums;

  private final Set<Kind> stated = EnumSet.of(Kind.SIDES);

  /**
   * @param axis unit vector: faces have weights by their angles to it
   * @param tolerance by which vertices may differ
   */
  SurfaceValues(PartShape shape, Vec3 axis, double tolerance) {
    this.axis = axis;
    this.tolerance = tolerance;
    double[] v = shape.vertices();
    for (int i = 0; i < v.length; i += 3) {
      index.number(v[i], v[i + 1], v[i + 2]);
    }
    sums = new double[Math.multiplyExact(STRIDE, shape.vertexCount())];
    shape.surfaces().forEach(this::add);
  }

  /**
   * Returns what two parts state differently at their common vertices; empty if they have none at
   * which triangles meet alike, so that nothing can be compared.
   *
   * @param motion that makes the vertices of the old part those of the new one
   * @param tolerance by which vertices may differ
   * @param hasLook whether more than the sides of triangles is compared
   */
  static Optional<Set<Kind>> differences(
      PartShape old,
      PartShape now,
      ShapeMatch.Motion motion,
      double tolerance,
      boolean hasLook) {
    SurfaceValues before = new SurfaceValues(old, AXIS, tolerance);
    SurfaceValues after = new SurfaceValues(now, motion.rotated(AXIS), tolerance);
    Set<Kind> kinds = EnumSet.copyOf(before.stated);
    kinds.addAll(after.stated);
    if (!hasLook) {
      kinds.retainAll(EnumSet.of(Kind.SIDES));
    }
    if (!before.stated.contains(Kind.MATERIALS) || !after.stated.contains(Kind.MATERIALS)) {
      kinds.remove(Kind.MATERIALS);
    }
    Set<Kind> found = EnumSet.noneOf(Kind.class);
    PointGrid grid = new PointGrid(now.vertices(), tolerance);
    int compared = 0;
    for (int i = 0; i < old.vertexCount(); i++) {
      Vec3 p = now.centroid().plus(motion.rotated(old.offset(i)));
      int other = grid.at(p.x(), p.y(), p.z());
      if (other != PointGrid.NONE && before.hasWeightOf(i, after, other)) {
        compared++;
        for (Kind kind : kinds) {
          if (before.differs(kind, i, after, other, motion)) {
            found.add(kind);
          }
        }
      }
    }
    return compared == 0 ? Optional.empty() : Optional.of(found);
  }

  private boolean hasWeightOf(int vertex, SurfaceValues other, int otherVertex) {
    double one = sums[STRIDE * vertex];
    double two = other.sums[STRIDE * otherVertex];
    return one > 0 && Math.abs(one - two) <= SAME_WEIGHT * one;
  }

  private boolean differs(
      Kind kind, int vertex, SurfaceValues other, int otherVertex, ShapeMatch.Motion motion) {
    int at = STRIDE * vertex + FIRST[kind.ordinal()];
    int otherAt = STRIDE * otherVertex + FIRST[kind.ordinal()];
    double[] one = Arrays.copyOfRange(sums, at, at + kind.size);
    if (kind.isDirection) {
      Vec3 turned = motion.rotated(new Vec3(one[0], one[1], one[2]));
      set(one, 0, turned);
    }
    double most = 0;
    double size = sums[STRIDE * vertex];
    for (int i = 0; i < kind.size; i++) {
      most = Math.max(most, Math.abs(one[i] - other.sums[otherAt + i]));
      size = Math.max(size, Math.abs(one[i]));
    }
    return most > kind.tolerance * size;
  }

  private static void set(double[] values, int at, Vec3 v) {
    values[at] = v.x();
    values[at + 1] = v.y();
    values[at + 2] = v.z();
  }

  private void add(PartShape.Surface surface) {
    ModelGeometry mesh = surface.part().geometry();
    state(Kind.NORMALS, mesh.normals().length);
    state(Kind.TANGENTS, mesh.tangents().length);
    state(Kind.TEXTURE, mesh.uv0().length);
    state(Kind.SECOND_TEXTURE, mesh.uv1().length);
    state(Kind.COLORS, mesh.colors().length);
    state(Kind.MATERIALS, surface.material().length());
    double[] values = new double[STRIDE];
    for (int i = 0; mesh.isPoints() && i < mesh.vertexCount(); i++) {
      read(surface, i, Vec3.ZERO, values);
      add(surface.part().position(i), 1, values);
    }
    int[] indices = mesh.indices();
    for (int i = 0; i < indices.length; i += 3) {
      if ((i & INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      addTriangle(surface, indices[i], indices[i + 1], indices[i + 2], values);
    }
  }

  private void state(Kind kind, int count) {
    if (count > 0) {
      stated.add(kind);
    }
  }

  private void addTriangle(PartShape.Surface surface, int a, int b, int c, double[] values) {
    Vec3[] p = {
      surface.part().position(a), surface.part().position(b), surface.part().position(c)
    };
    Vec3 cross = p[1].minus(p[0]).cross(p[2].minus(p[0]));
    double twice = cross.length();
    double longest =
        Math.max(
            p[1].minus(p[0]).length(),
            Math.max(p[2].minus(p[1]).length(), p[0].minus(p[2]).length()));
    if (!(twice > LOWEST * tolerance * longest)) {
      return;
    }
    Vec3 normal = cross.times(1 / twice);
    double along = axis.dot(normal);
    int[] corners = {a, b, c};
    for (int k = 0; k < 3; k++) {
      double cosine =
          p[(k + 1) % 3].minus(p[k]).dot(p[(k + 2) % 3].minus(p[k]));
      read(surface, corners[k], normal, values);
      add(p[k], Elementary.atan2(twice, cosine) * (1 + .5 * along * along), values);
    }
  }

  private void add(Vec3 position, double weight, double[] values) {
    int at = STRIDE * index.number(position.x(), position.y(), position.z());
    sums[at] += weight;
    for (int i = 1; i < STRIDE; i++) {
      sums[at + i] += weight * values[i];
    }
  }

  /** Reads what a surface states at a vertex, with defaults for what it does not state. */
  private static void read(PartShape.Surface surface, int v, Vec3 side, double[] values) {
    ModelGeometry mesh = surface.part().geometry();
    Transform toWorld = surface.part().toWorld();
    set(values, FIRST[Kind.SIDES.ordinal()], side);
    set(
        values,
        FIRST[Kind.NORMALS.ordinal()],
        mesh.normals().length == 0 ? side : toWorld.normal(vector(mesh.normals(), 3 * v)));
    int tangent = FIRST[Kind.TANGENTS.ordinal()];
    boolean hasTangents = mesh.tangents().length > 0;
    set(
        values,
        tangent,
        hasTangents ? toWorld.vector(vector(mesh.tangents(), 4 * v)).normalized() : Vec3.ZERO);
    values[tangent + 3] = hasTangents ? mesh.tangents()[4 * v + 3] : 0;
    for (int i = 0; i < 2; i++) {
      values[FIRST[Kind.TEXTURE.ordinal()] + i] = at(mesh.uv0(), 2 * v + i);
      values[FIRST[Kind.SECOND_TEXTURE.ordinal()] + i] = at(mesh.uv1(), 2 * v + i);
    }
    for (int i = 0; i < 4; i++) {
      values[FIRST[Kind.COLORS.ordinal()] + i] =
          mesh.colors().length == 0 ? 1 : mesh.colors()[4 * v + i];
    }
    values[FIRST[Kind.MATERIALS.ordinal()]] = (surface.material().hashCode() & 0xffff) / 65536.;
  }

  private static double at(double[] values, int i) {
    return values.length == 0 ? 0 : values[i];
  }

  private static Vec3 vector(double[] values, int at) {
    return new Vec3(values[at], values[at + 1], values[at + 2]);
  }
}
