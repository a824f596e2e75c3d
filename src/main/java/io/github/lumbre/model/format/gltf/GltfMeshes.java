package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelGeometry;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;

/** The meshes of a glTF file (glTF 2.0, section 3.7). Mutable: each mesh is built once. */
final class GltfMeshes {
  private static final int POINTS = 0;
  private static final int MAX_MODE = 6;

  private final GltfDocument document;
  private final GltfAccessors accessors;
  private final GltfAttributes attributes;
  private final GltfMorph morph;
  private final GltfDraco draco;
  private final GltfPoints points;

  /** The geometries by the location of the primitive and the weights of its morph targets. */
  private final Map<Map.Entry<String, List<Double>>, Optional<ModelGeometry>> forms =
      new HashMap<>();

  private final Map<Corners, int[]> corners = new HashMap<>();

  /** Which vertices the triangles of a primitive use. */
  private record Corners(Optional<GltfAccessor> indices, int mode, int vertices) {
    // Java would make the code of the next two at the first call, which delays each start.

    @Override
    public boolean equals(Object other) {
      return other instanceof Corners corners
          && indices.equals(corners.indices)
          && mode == corners.mode
          && vertices == corners.vertices;
    }

    @Override
    public int hashCode() {
      return Objects.hash(indices, mode, vertices);
    }
  }

  GltfMeshes(
      GltfDocument document, GltfAccessors accessors, GltfAttributes attributes, GltfDraco draco) {
    this.document = document;
    this.draco = draco;
    this.accessors = accessors;
    this.attributes = attributes;
    morph = new GltfMorph(document, attributes);
    points = new GltfPoints(document, accessors, attributes, draco);
  }

  /**
   * Returns the triangles of a primitive, or the vertices of one that is points; empty if it has
   * none. {@link #shown} selects the points among the vertices, after a skin has moved them.
   *
   * @param weights of its morph targets; may be fewer
   */
  Optional<ModelGeometry> geometry(GltfJson primitive, double... weights)
      throws ModelFormatException, IOException {
    boolean isRest = Arrays.stream(weights).allMatch(w -> w == 0) || !primitive.has("targets");
    List<Double> applied = isRest ? List.of() : Arrays.stream(weights).boxed().toList();
    Map.Entry<String, List<Double>> form = Map.entry(primitive.location(), applied);
    Optional<ModelGeometry> geometry = forms.get(form);
    if (geometry == null) {
      geometry = isRest ? rest(primitive) : morphed(primitive, weights);
      forms.put(form, geometry);
    }
    return geometry;
  }

  /**
   * Returns the triangles or points of a primitive in world space, without normals: those of a node
   * that flattens them to a plane, or points of one that would make ellipsoids of them.
   */
  ModelGeometry flattened(GltfJson primitive, ModelGeometry rest, Transform toWorld)
      throws ModelFormatException {
    double[] positions = rest.positions();
    document.budget().allocate(primitive.location(), (long) Double.BYTES * positions.length);
    double[] moved = new double[positions.length];
    for (int i = 0; i < moved.length; i += 3) {
      Vec3 p = toWorld.point(new Vec3(positions[i], positions[i + 1], positions[i + 2]));
      moved[i] = p.x();
      moved[i + 1] = p.y();
      moved[i + 2] = p.z();
    }
    double[] none = {};
    return GltfVectors.checked(primitive, rest.moved(moved, none, none, rest.indices()));
  }

  /** Returns what is shown of a primitive's {@link #geometry}: all triangles, or the points. */
  ModelGeometry shown(GltfJson primitive, ModelGeometry all) throws ModelFormatException {
    return all.isPoints() ? points.shown(primitive, all) : all;
  }

  private Optional<ModelGeometry> morphed(GltfJson primitive, double... weights)
      throws ModelFormatException, IOException {
    Optional<ModelGeometry> rest = geometry(primitive);
    return rest.isPresent()
        ? Optional.of(morph.applied(primitive, rest.get(), weights))
            .filter(moved -> moved.itemCount() > 0)
        : Optional.empty();
  }

  private Optional<ModelGeometry> rest(GltfJson primitive)
      throws ModelFormatException, IOException {
    Interrupts.check();
    int mode = (int) primitive.whole("mode", GltfTriangles.LIST, 0, MAX_MODE);
    GltfJson json = primitive.requireObject("attributes");
    boolean isLine = mode != POINTS && mode < GltfTriangles.LIST;
    if (isLine || !json.has("POSITION")) {
      warn(primitive, isLine ? "lines are left out" : "a mesh without positions is left out");
      return Optional.empty();
    }
    if (mode == POINTS) {
      return points.rest(primitive);
    }
    boolean isDecoded = draco.decode(primitive, mode);
    GltfAccessor position = accessors.require(json, "POSITION");
    double[] positions = attributes.positions(position);
    int vertices = positions.length / 3;
    int[] all = indices(primitive, isDecoded, isDecoded ? GltfTriangles.LIST : mode, vertices);
    int[] indices = GltfTriangles.whole(document, primitive, attributes.broken(position), all);
    if (indices.length == 0) {
      warn(primitive, "a mesh without triangles is left out");
      return Optional.empty();
    }
    double[] normals = attributes.normals(json, vertices);
    return Optional.of(
        new ModelGeometry(
            positions,
            normals,
            normals.length == 0 ? normals : attributes.tangents(json, vertices),
            attributes.uvs(json, "TEXCOORD_0", vertices),
            attributes.uvs(json, "TEXCOORD_1", vertices),
            attributes.colors(json, vertices),
            indices));
  }

  private void warn(GltfJson primitive, String message) {
    document.warnings().add(primitive.location(), message);
  }

  private int[] indices(GltfJson primitive, boolean isDecoded, int mode, int vertices)
      throws ModelFormatException, IOException {
    Optional<GltfAccessor> accessor =
        isDecoded || primitive.has("indices")
            ? Optional.of(accessors.require(primitive, "indices"))
            : Optional.empty();
    int count = accessor.isPresent() ? accessor.get().count() : vertices;
    if (mode == GltfTriangles.LIST && count % 3 != 0) {
      warn(primitive, "expected three corners per triangle, found " + count + " corners in all");
    }
    Corners key = new Corners(accessor, mode, vertices);
    int[] found = corners.get(key);
    if (found == null) {
      found = triangles(primitive, key, count);
      corners.put(key, found);
    }
    return found;
  }

  private int[] triangles(GltfJson primitive, Corners key, int count)
      throws ModelFormatException, IOException {
    GltfBudget budget = document.budget();
    budget.addIndices(primitive.location(), 3L * GltfTriangles.count(key.mode, count));
    int[] read;
    if (key.indices.isPresent()) {
      read = accessors.vertices(primitive, key.vertices);
    } else {
      budget.allocate(primitive.location(), (long) Integer.BYTES * count);
      read = IntStream.range(0, count).toArray();
    }
    return GltfTriangles.list(key.mode, read);
  }
}
