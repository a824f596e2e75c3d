package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.BodySide;
import io.github.lumbre.model.internal.ModelGeometry;
import java.util.IdentityHashMap;
import java.util.Map;

/**
 * Keeps the fronts of one-sided meshes that morph targets turn inside out: their triangles are
 * turned around, so that the outside stays what is seen. Mutable: each mesh is turned once.
 */
final class GltfFronts {
  private final GltfDocument document;
  private final Map<ModelGeometry, ModelGeometry> kept = new IdentityHashMap<>();

  GltfFronts(GltfDocument document) {
    this.document = document;
  }

  /**
   * Returns a one-sided mesh with the fronts that it has at rest.
   *
   * @param rest the mesh without morph targets
   * @param posed the same mesh, moved by them
   */
  ModelGeometry kept(GltfJson primitive, ModelGeometry rest, ModelGeometry posed)
      throws ModelFormatException {
    ModelGeometry known = kept.get(posed);
    if (known == null) {
      known = isTurned(rest, posed) ? turned(primitive, posed) : posed;
      kept.put(posed, known);
    }
    return known;
  }

  private static boolean isTurned(ModelGeometry rest, ModelGeometry posed) {
    return rest != posed && !posed.isPoints() && BodySide.of(rest) * BodySide.of(posed) < 0;
  }

  private ModelGeometry turned(GltfJson primitive, ModelGeometry mesh)
      throws ModelFormatException {
    String location = primitive.location();
    document.budget().allocate(location, (long) Integer.BYTES * mesh.indices().length);
    int[] indices = mesh.indices().clone();
    for (int i = 0; i < indices.length; i += 3) {
      int second = indices[i + 1];
      indices[i + 1] = indices[i + 2];
      indices[i + 2] = second;
    }
    document
        .warnings()
        .add(location, "the pose turns the mesh inside out; its front stays where it is at rest");
    return mesh.moved(mesh.positions(), mesh.normals(), mesh.tangents(), indices);
  }
}
