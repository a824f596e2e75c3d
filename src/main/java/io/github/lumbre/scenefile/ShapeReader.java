package io.github.lumbre.scenefile;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SharedMesh;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Reads shapes. A mesh with one instance is transformed to world space; a mesh with several
 * instances is shared.
 */
final class ShapeReader {
  /** The largest absolute coordinate: squares of coordinates must not overflow. */
  private static final double MAX_REACH = 1e150;

  private final MeshReader meshes;
  private final Kernel kernel;
  private final Map<JsonNode, Integer> placements = new HashMap<>();
  private final Map<JsonNode, Optional<JsonNode>> meshOfObject = new HashMap<>();
  private final Map<JsonNode, SharedMesh> shared = new HashMap<>();
  private final Set<String> keys = ShapeKinds.FAMILY.keys();
  private int count;
  private long triangles;

  /**
   * @param shapes all shape objects of the scene
   * @param kernel traversal kernel of shared meshes
   */
  ShapeReader(MeshReader meshes, List<Placed> shapes, Kernel kernel) {
    this.meshes = meshes;
    this.kernel = kernel;
    for (Placed shape : shapes) {
      countPlacement(shape.node());
    }
  }

  private void countPlacement(JsonNode object) {
    String kind = ShapeKinds.FAMILY.typeKey().name();
    if (object.find(kind).filter(type -> type.isText(ShapeKinds.MESHES)).isPresent()) {
      Optional<JsonNode> asset = meshes.asset(object);
      meshOfObject.put(object, asset);
      asset.ifPresent(a -> placements.merge(a, 1, Integer::sum));
    }
  }

  /** Returns the number of shapes read so far. */
  int count() {
    return count;
  }

  /** Returns the number of triangles read so far, counted for each mesh instance. */
  long triangles() {
    return triangles;
  }

  /** Returns the shape of an object; empty, with a problem added, if it cannot be rendered. */
  Optional<Shape> read(Placed object) {
    JsonNode node = object.node();
    node.warnUnknown(keys);
    count++;
    return ShapeKinds.FAMILY
        .choose(node)
        .flatMap(reader -> reader.apply(object, this))
        .filter(shape -> shape instanceof Plane || isMeasurable(node.spot(), shape));
  }

  /**
   * Returns whether a shape lies within 1e150 of the origin, so that its area does not overflow;
   * adds an error if it does not.
   */
  static boolean isMeasurable(Spot spot, Shape shape) {
    return isMeasurable(spot, shape.bounds());
  }

  /** Returns whether a box lies within 1e150 of the origin; adds an error if it does not. */
  static boolean isMeasurable(Spot spot, Bounds3 bounds) {
    double reach = Math.max(bounds.min().maxAbs(), bounds.max().maxAbs());
    if (reach <= MAX_REACH) {
      return true;
    }
    spot.error(
        Kind.INVALID, "expected a shape within 1e150 of the origin, found one that extends beyond");
    return false;
  }

  /** Returns the mesh of an object; empty, with a problem added, if there is none. */
  Optional<Shape> mesh(Placed object) {
    Optional<JsonNode> asset = meshOfObject.get(object.node());
    if (asset.isEmpty()) {
      object.node().warn(ShapeKinds.MESH.name(), "names no mesh; the object is not rendered");
      return Optional.empty();
    }
    return meshes.read(asset.get()).map(mesh -> placed(object, asset.get(), mesh));
  }

  private Shape placed(Placed object, JsonNode asset, TriangleMesh mesh) {
    triangles += mesh.triangleCount();
    boolean isShared = ShapeKinds.SHARED.in(object.node());
    if (placements.get(asset) == 1 && !isShared) {
      return Mesh.baked(mesh, object.toWorld());
    }
    SharedMesh one = shared.computeIfAbsent(asset, a -> new SharedMesh(mesh, kernel));
    return new MeshInstance(one, object.toWorld());
  }
}
