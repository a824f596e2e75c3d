package io.github.lumbre.geometry;

import io.github.lumbre.math.Transform;
import java.util.List;

/**
 * A mesh with a hierarchy over its triangles in local space, to be placed many times by {@link
 * MeshInstance}. Immutable.
 */
public final class SharedMesh {
  private final TriangleMesh mesh;
  private final Bvh bvh;

  /** Returns a mesh that is searched by {@link Kernel#AUTO}. */
  public SharedMesh(TriangleMesh mesh) {
    this(mesh, Kernel.AUTO);
  }

  /**
   * Returns a mesh that is searched by a kernel.
   *
   * @throws IllegalStateException if the kernel is not available
   */
  public SharedMesh(TriangleMesh mesh, Kernel kernel) {
    this.mesh = mesh;
    bvh = Bvh.over(List.of(Mesh.baked(mesh, Transform.IDENTITY)), kernel);
  }

  public TriangleMesh mesh() {
    return mesh;
  }

  Bvh bvh() {
    return bvh;
  }
}
