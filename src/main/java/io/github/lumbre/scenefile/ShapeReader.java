package io.github.lumbre.scenefile;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SharedMesh;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.obj.ObjMesh;
import io.github.lumbre.model.format.obj.ObjReader;
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

  private final AssetData data;
  private final Kernel kernel;
  private final Map<JsonNode, Integer> placements = new HashMap<>();
  private final Map<JsonNode, Optional<JsonNode>> meshOfObject = new HashMap<>();
  private final Map<JsonNode, Optional<TriangleMesh>> meshes = new HashMap<>();
  private final Map<JsonNode, SharedMesh> shared = new HashMap<>();
  private final Set<String> keys = ShapeKinds.FAMILY.keys();
  private int count;
  private long triangles;

  /**
   * @param shapes all shape objects of the scene
   * @param kernel traversal kernel of shared meshes
   */
  ShapeReader(AssetTable assets, AssetData data, List<Placed> shapes, Kernel kernel) {
    this.data = data;
    this.kernel = kernel;
    for (Placed shape : shapes) {
      JsonNode object = shape.node();
      Optional<JsonNode> type = ShapeKinds.FAMILY.typeKey().find(object);
      if (type.filter(t -> t.isText(ShapeKinds.MESHES)).isPresent()) {
        Optional<JsonNode> asset = assets.find(object, ShapeKinds.MESH, AssetTable.Type.MESH);
        meshOfObject.put(object, asset);
        asset.ifPresent(a -> placements.merge(a, 1, Integer::sum));
      }
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
        .filter(s -> s instanceof Plane || isMeasurable(node.problemPlace(), s.bounds()));
  }

  /**
   * Returns whether a box lies within 1e150 of the origin, so that areas do not overflow; adds an
   * error if it does not.
   */
  static boolean isMeasurable(ProblemPlace place, Bounds3 bounds) {
    double reach = Math.max(bounds.min().maxAbs(), bounds.max().maxAbs());
    if (reach <= MAX_REACH) {
      return true;
    }
    place.error(
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
    return meshes
        .computeIfAbsent(asset.get(), this::read)
        .map(mesh -> placed(object, asset.get(), mesh));
  }

  private Optional<TriangleMesh> read(JsonNode asset) {
    return data.read(asset, ObjectKeys.BASE64_MESH).flatMap(this::decoded);
  }

  private Optional<TriangleMesh> decoded(AssetData.Content content) {
    ObjMesh obj;
    try {
      obj = ObjReader.read(content.bytes(), data.allowance().left());
    } catch (ModelFormatException e) {
      content.error(ModelPlace.kind(e), e.getMessage());
      return Optional.empty();
    }
    data.allowance().addTriangles(obj.indices().length / 3);
    TriangleMesh mesh = TriangleMesh.of(obj.positions(), obj.normals(), obj.uvs(), obj.indices());
    if (mesh.droppedTriangles() > 0) {
      content.warn("dropped triangles of zero area: " + mesh.droppedTriangles());
    }
    return mesh.triangleCount() == 0 ? Optional.empty() : Optional.of(mesh);
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
