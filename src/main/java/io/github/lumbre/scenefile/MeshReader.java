package io.github.lumbre.scenefile;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.obj.ObjMesh;
import io.github.lumbre.model.format.obj.ObjReader;
import io.github.lumbre.scenefile.AssetTable.Type;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Reads each mesh at its first use. */
final class MeshReader {
  private final AssetTable assets;
  private final AssetData data;
  private final Map<JsonNode, Optional<TriangleMesh>> meshes = new HashMap<>();

  MeshReader(AssetTable assets, AssetData data) {
    this.assets = assets;
    this.data = data;
  }

  /** Warns of keys that no mesh has. */
  void checkAll() {
    Set<String> known = Key.names(ObjectKeys.OF_ASSETS);
    known.addAll(Key.names(ObjectKeys.OF_MESHES));
    assets.all(Type.MESH).forEach(mesh -> mesh.warnUnknown(known));
  }

  /** Returns whether any object uses a mesh. */
  boolean uses(JsonNode mesh) {
    return meshes.containsKey(mesh);
  }

  /** Returns the number of meshes in use. */
  int count() {
    return meshes.size();
  }

  /** Returns the mesh asset that an object names; empty if there is none. */
  Optional<JsonNode> asset(JsonNode object) {
    return assets.find(object, ShapeKinds.MESH, Type.MESH);
  }

  /** Returns a mesh; empty, with an error added, if it cannot be used. */
  Optional<TriangleMesh> read(JsonNode asset) {
    String base64 = ObjectKeys.BASE64_MESH.name();
    return meshes.computeIfAbsent(asset, a -> data.read(a, base64).flatMap(this::decoded));
  }

  private Optional<TriangleMesh> decoded(AssetData.Content content) {
    ObjMesh obj;
    try {
      obj = ObjReader.read(content.bytes(), data.allowance().left());
    } catch (ModelFormatException e) {
      content.error(
          e.kind() == ModelFormatException.Kind.TOO_LARGE ? Kind.LIMIT : Kind.ASSET,
          e.getMessage());
      return Optional.empty();
    }
    data.allowance().addTriangles(obj.indices().length / 3);
    TriangleMesh mesh = TriangleMesh.of(obj.positions(), obj.normals(), obj.uvs(), obj.indices());
    if (mesh.droppedTriangles() > 0) {
      content.warn("dropped triangles of zero area: " + mesh.droppedTriangles());
    }
    return mesh.triangleCount() == 0 ? Optional.empty() : Optional.of(mesh);
  }
}
