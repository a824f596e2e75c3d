package io.github.lumbre.geometry;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Objects;

/**
 * Further data of a mesh's vertices. An attribute that the mesh lacks is an empty array. The arrays
 * are not copied and must not be changed.
 *
 * @param tangents four numbers per vertex: a unit vector along increasing u in local space, and 1
 *     or -1: the bitangent is the cross product of normal and tangent times this number
 * @param uv1 a second set of texture coordinates: two numbers per vertex
 * @param colors four linear numbers per vertex: red, green, blue and alpha, each at least 0
 */
public record MeshAttributes(double[] tangents, double[] uv1, float[] colors) {
  /** No further data. */
  public static final MeshAttributes NONE =
      new MeshAttributes(new double[0], new double[0], new float[0]);

  public MeshAttributes {
    Objects.requireNonNull(tangents, "tangents");
    Objects.requireNonNull(uv1, "uv1");
    Objects.requireNonNull(colors, "colors");
  }

  /** Returns the attributes of some vertices. */
  MeshAttributes part(int[] vertices) {
    float[] some = new float[colors.length == 0 ? 0 : 4 * vertices.length];
    for (int i = 0; i < some.length; i += 4) {
      System.arraycopy(colors, 4 * vertices[i / 4], some, i, 4);
    }
    return new MeshAttributes(
        TriangleMesh.selected(tangents, vertices, 4),
        TriangleMesh.selected(uv1, vertices, 2),
        some);
  }

  /** Returns these attributes with their tangents in world space. */
  MeshAttributes mapped(Transform toWorld) {
    if (tangents.length == 0) {
      return this;
    }
    double[] mapped = tangents.clone();
    for (int i = 0; i < mapped.length; i += 4) {
      Vec3 tangent = toWorld.vector(new Vec3(mapped[i], mapped[i + 1], mapped[i + 2]));
      Vec3 unit = tangent.maxAbs() > 0 ? tangent.normalized() : tangent;
      mapped[i] = unit.x();
      mapped[i + 1] = unit.y();
      mapped[i + 2] = unit.z();
      mapped[i + 3] *= toWorld.isMirroring() ? -1 : 1;
    }
    return new MeshAttributes(mapped, uv1, colors);
  }
}
