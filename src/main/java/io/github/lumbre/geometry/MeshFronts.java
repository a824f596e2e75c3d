package io.github.lumbre.geometry;

import io.github.lumbre.geometry.TriangleMesh.Front;
import io.github.lumbre.math.Vec3;

/**
 * Which side of each triangle of a mesh is its front, and where its vertex normals point.
 * Immutable.
 *
 * @param rule what decides it
 * @param sides where the vertex normals of each triangle point; empty if all are on the front
 * @param mirrored whether the mesh was baked with a mirroring transform, which flips every cross
 *     product
 */
record MeshFronts(Front rule, byte[] sides, boolean mirrored) {
  /** All vertex normals of a triangle are on its front. */
  private static final byte REGULAR = 0;

  /** {@link Front#NORMALS}: the front is opposite to the cross product. */
  private static final byte TURNED = 1;

  /** {@link Front#WINDING}: a vertex normal is on the back. */
  private static final byte BEHIND = 2;

  /** {@link Front#WINDING}: the vertex normals are reversed. */
  private static final byte REVERSED = 3;

  /** Returns the fronts of a mesh that was not baked. */
  static MeshFronts of(TriangleMesh mesh, Front rule) {
    byte[] sides = new byte[mesh.hasNormals() ? mesh.triangleCount() : 0];
    boolean isRegular = true;
    for (int i = 0; i < sides.length; i++) {
      sides[i] = side(mesh, i, rule);
      isRegular &= sides[i] == REGULAR;
    }
    return new MeshFronts(rule, isRegular ? new byte[0] : sides, false);
  }

  private static byte side(TriangleMesh mesh, int triangle, Front rule) {
    int first = mesh.vertex(triangle, 0);
    int second = mesh.vertex(triangle, 1);
    int third = mesh.vertex(triangle, 2);
    Vec3 a = mesh.position(first);
    Vec3 cross = TriangleMesh.cross(mesh.position(second).minus(a), mesh.position(third).minus(a));
    Vec3 n0 = mesh.normal(first);
    Vec3 n1 = mesh.normal(second);
    Vec3 n2 = mesh.normal(third);
    Vec3 sum = n0.plus(n1).plus(n2);
    if (rule == Front.NORMALS) {
      return cross.dot(sum) < 0 ? TURNED : REGULAR;
    }
    if (cross.dot(sum) < -Math.sqrt(.5) * cross.length() * sum.length()) {
      return REVERSED;
    }
    return cross.dot(n0) < 0 || cross.dot(n1) < 0 || cross.dot(n2) < 0 ? BEHIND : REGULAR;
  }

  /** Returns the fronts of the mesh after it was baked with a transform. */
  MeshFronts baked(boolean isMirroring) {
    return new MeshFronts(rule, sides, mirrored ^ isMirroring);
  }

  /** Returns whether each front is decided as in {@link Front#NORMALS}. */
  boolean isPlain() {
    return rule == Front.NORMALS || sides.length == 0;
  }

  /** Returns whether the normal of a triangle's front is opposite to the edges' cross product. */
  boolean isTurned(int triangle) {
    return (sides.length > 0 && sides[triangle] == TURNED) ^ mirrored;
  }

  /** Returns whether shading turns the vertex normals of a triangle around; see {@link Front}. */
  boolean hasNormalsBehind(int triangle) {
    return sides.length > 0 && sides[triangle] >= BEHIND;
  }

  /** Returns whether all three vertex normals of a triangle are negated for shading. */
  boolean hasReversedNormals(int triangle) {
    return sides.length > 0 && sides[triangle] == REVERSED;
  }
}
