package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.format.draco.DracoAttribute;
import io.github.lumbre.model.format.draco.DracoLimits;
import io.github.lumbre.model.format.draco.DracoMesh;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Primitives that are compressed (KHR_draco_mesh_compression). Primitives with the same data share
 * the decoded accessors. Mutable.
 */
final class GltfDraco {
  static final String EXTENSION = "KHR_draco_mesh_compression";

  private final GltfDocument document;
  private final GltfAccessors accessors;
  private final GltfBuffers buffers;
  private final boolean isRequired;
  private final Map<Integer, DracoMesh> meshes = new HashMap<>();
  private final Map<Key, GltfAccessor> decoded = new HashMap<>();

  /**
   * What is decoded.
   *
   * @param view the index of a buffer view
   * @param id of an attribute; negative for the corners of the triangles
   */
  private record Key(int view, long id) {
    private static final long CORNERS = -1;
  }

  GltfDraco(GltfDocument document, GltfAccessors accessors, GltfBuffers buffers)
      throws ModelFormatException {
    this.document = document;
    this.accessors = accessors;
    this.buffers = buffers;
    isRequired = document.root().texts("extensionsRequired").contains(EXTENSION);
  }

  /**
   * Replaces the accessors of a primitive by decoded ones if it is compressed. If the data is
   * damaged and the file also has plain accessors, they stay, with a warning.
   *
   * @param mode of the primitive: a list, strip or fan of triangles
   * @return whether the primitive was decoded: its accessors are then a list of triangles
   */
  boolean decode(GltfJson primitive, int mode) throws ModelFormatException, IOException {
    Optional<GltfJson> extension = primitive.extension(EXTENSION);
    if (extension.isEmpty()) {
      return false;
    }
    try {
      replace(primitive, extension.get(), mode);
      return true;
    } catch (ModelFormatException e) {
      if (isRequired || e.kind() == Kind.TOO_LARGE || !hasPlainAccessors(primitive)) {
        throw e;
      }
      String message = e.getMessage() + "; the uncompressed mesh is used";
      document.warnings().add("an uncompressed mesh is used", "", message);
      return false;
    }
  }

  /** Returns whether a primitive has data only in its compressed form. */
  boolean isOnlyCompressed(GltfJson primitive) throws ModelFormatException {
    return primitive.extension(EXTENSION).isPresent() && !hasPlainAccessors(primitive);
  }

  private boolean hasPlainAccessors(GltfJson primitive) throws ModelFormatException {
    return (!primitive.has("indices") || accessor(primitive, "indices").has("bufferView"))
        && accessor(primitive.requireObject("attributes"), "POSITION").has("bufferView");
  }

  private GltfJson accessor(GltfJson object, String member) throws ModelFormatException {
    return document.section("accessors").get(document.requireIndex(object, member, "accessors"));
  }

  private void replace(GltfJson primitive, GltfJson extension, int mode)
      throws ModelFormatException, IOException {
    int view = document.requireIndex(extension, "bufferView", "bufferViews");
    DracoMesh mesh = mesh(view, primitive, extension, mode);
    GltfJson attributes = primitive.requireObject("attributes");
    GltfJson ids = extension.requireObject("attributes");
    Map<String, GltfAccessor> replacements = new LinkedHashMap<>();
    for (String name : ids.keys()) {
      if (attributes.has(name)) {
        replacements.put(name, attribute(view, mesh, ids, name, accessor(attributes, name)));
      }
    }
    if (!replacements.containsKey("POSITION")) {
      throw ids.expected("POSITION", "the number of an attribute");
    }
    accessors.replace(primitive, "indices", corners(view, mesh, extension.location()));
    replacements.forEach((name, accessor) -> accessors.replace(attributes, name, accessor));
  }

  private DracoMesh mesh(int view, GltfJson primitive, GltfJson extension, int mode)
      throws ModelFormatException, IOException {
    DracoMesh mesh = meshes.get(view);
    if (mesh == null) {
      String location = extension.location("bufferView");
      DracoLimits limits =
          new DracoLimits(
              maxFaces(primitive, mode),
              count(accessor(primitive.requireObject("attributes"), "POSITION")),
              bytes -> document.budget().allocate(location, bytes));
      mesh = DracoMesh.decode(buffers.copyOfView(extension), location, limits);
      meshes.put(view, mesh);
    }
    if (primitive.has("indices") && mode == GltfTriangles.LIST) {
      warnOfCount(accessor(primitive, "indices"), mesh.corners().length);
    }
    return mesh;
  }

  /** Returns the largest number of faces; compression may remove some of those that were there. */
  private long maxFaces(GltfJson primitive, int mode) throws ModelFormatException {
    return primitive.has("indices")
        ? GltfTriangles.count(mode, count(accessor(primitive, "indices")))
        : GltfBudget.MAX_COUNT / 3;
  }

  private static int count(GltfJson accessor) throws ModelFormatException {
    return (int) accessor.requireWhole("count", 0, GltfBudget.MAX_COUNT);
  }

  private void warnOfCount(GltfJson accessor, int found) throws ModelFormatException {
    int count = count(accessor);
    if (count != found) {
      String message = "expected " + count + " elements, found " + found + " in its Draco data";
      document.warnings().add("other numbers of elements", accessor.location("count"), message);
    }
  }

  private GltfAccessor corners(int view, DracoMesh mesh, String location)
      throws ModelFormatException {
    Key key = new Key(view, Key.CORNERS);
    GltfAccessor accessor = decoded.get(key);
    if (accessor == null) {
      int size = Integer.BYTES * mesh.corners().length;
      document.budget().allocate(location, size);
      ByteBuffer bytes = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
      bytes.asIntBuffer().put(mesh.corners());
      accessor = GltfAccessor.over(bytes, GltfComponent.UNSIGNED_INT, 1, false, location);
      decoded.put(key, accessor);
    }
    return accessor;
  }

  /** Returns a decoded attribute in place of an accessor. */
  private GltfAccessor attribute(
      int view, DracoMesh mesh, GltfJson ids, String name, GltfJson plain)
      throws ModelFormatException {
    long id = ids.requireWhole(name, 0, Integer.MAX_VALUE);
    DracoAttribute attribute =
        mesh.attributes().stream()
            .filter(a -> a.id() == id)
            .findFirst()
            .orElseThrow(() -> ids.expected(name, "the number of an attribute of its Draco data"));
    int components = GltfAccessor.components(plain);
    if (components != attribute.components()) {
      throw plain.malformed(
          "type",
          "expected %d numbers per element, found %d in its Draco data"
              .formatted(components, attribute.components()));
    }
    warnOfCount(plain, mesh.pointCount());
    GltfComponent component = component(attribute, ids.location(name));
    boolean isNormalized =
        component == GltfComponent.of(plain, "componentType")
            ? plain.flag("normalized", false)
            : attribute.isNormalized();
    Key key = new Key(view, id);
    GltfAccessor accessor = decoded.get(key);
    if (accessor == null) {
      accessor =
          GltfAccessor.over(
              attribute.values(), component, components, isNormalized, ids.location(name));
      decoded.put(key, accessor);
    }
    return accessor;
  }

  private static GltfComponent component(DracoAttribute attribute, String location)
      throws ModelFormatException {
    return switch (attribute.type()) {
      case INT8 -> GltfComponent.BYTE;
      case UINT8 -> GltfComponent.UNSIGNED_BYTE;
      case INT16 -> GltfComponent.SHORT;
      case UINT16 -> GltfComponent.UNSIGNED_SHORT;
      case UINT32 -> GltfComponent.UNSIGNED_INT;
      case FLOAT32 -> GltfComponent.FLOAT;
      default ->
          throw Kind.UNSUPPORTED.at(
              location, "expected a type of numbers that glTF has, found " + attribute.type());
    };
  }
}
