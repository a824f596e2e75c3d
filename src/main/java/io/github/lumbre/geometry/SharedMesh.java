package io.github.lumbre.geometry;

import io.github.lumbre.math.Transform;
import java.util.List;

/**
 * A mesh and a hierarchy over its triangles in local space, which any number of {@link
 * MeshInstance}s share. Immutable.
 */
public final class SharedMesh {
  private final TriangleMesh mesh;
  private final Bvh bvh;

  /** Creates a mesh whose hierarchy uses {@link Kernel#AUTO}. */
  public SharedMesh(TriangleMesh mesh) {
    this(mesh, Kernel.AUTO);
  }

  /**
   * Creates a mesh whose hierarchy uses the given kernel.
   *
   * @throws IllegalStateException if the kernel is not available
   */
  public SharedMesh(TriangleMesh mesh, Kernel kernel) {
    this.mesh = mesh;
    bvh = Bvh.over(List.of(Mesh.baked(mesh, Transform.IDENTITY)), kernel);
  }

  /** Returns the mesh in local space. */
  public TriangleMesh mesh() {
    return mesh;
  }

  Bvh bvh() {
    return bvh;
  }
}
