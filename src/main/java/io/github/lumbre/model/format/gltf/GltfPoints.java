package io.github.lumbre.model.format.gltf;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelGeometry;
import java.io.IOException;
import java.util.BitSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;

/** The primitives of a glTF file that are points. Their normals are not used. Mutable. */
final class GltfPoints {
  /** How much the lengths of the images of the axes differ in a uniform scale, by rounding. */
  private static final double ROUNDING = 1e-6;

  /** Heap bytes of a vertex with all attributes that points have. */
  private static final long BYTES_PER_VERTEX = 9L * Double.BYTES;

  private final GltfDocument document;
  private final GltfAccessors accessors;
  private final GltfAttributes attributes;
  private final GltfDraco draco;

  /** The vertices that are no points, by the places of primitives. */
  private final Map<String, BitSet> hidden = new HashMap<>();

  private final Map<ModelGeometry, ModelGeometry> shown = new IdentityHashMap<>();

  GltfPoints(
      GltfDocument document, GltfAccessors accessors, GltfAttributes attributes, GltfDraco draco) {
    this.document = document;
    this.accessors = accessors;
    this.attributes = attributes;
    this.draco = draco;
  }

  /** Returns all vertices of a primitive, before {@link #shown}; empty if none is a point. */
  Optional<ModelGeometry> rest(GltfJson primitive) throws ModelFormatException, IOException {
    if (draco.isOnlyCompressed(primitive)) {
      warn(primitive, "points compressed with Draco are left out");
      return Optional.empty();
    }
    GltfJson json = primitive.requireObject("attributes");
    GltfAccessor position = accessors.require(json, "POSITION");
    double[] positions = attributes.positions(position);
    int vertices = positions.length / 3;
    BitSet visible = used(primitive, vertices);
    int used = visible.cardinality();
    visible.andNot(attributes.broken(position));
    if (visible.cardinality() < used) {
      int lost = used - visible.cardinality();
      warn(primitive, "left out points that are not finite numbers: " + lost);
    }
    if (visible.isEmpty()) {
      warn(primitive, "a mesh without points is left out");
      return Optional.empty();
    }
    if (visible.cardinality() < vertices) {
      visible.flip(0, vertices);
      hidden.put(primitive.location(), visible);
    }
    return Optional.of(
        ModelGeometry.ofPoints(
            positions,
            attributes.uvs(json, "TEXCOORD_0", vertices),
            attributes.uvs(json, "TEXCOORD_1", vertices),
            attributes.colors(json, vertices)));
  }

  private BitSet used(GltfJson primitive, int vertices) throws ModelFormatException, IOException {
    BitSet used = new BitSet(vertices);
    if (!primitive.has("indices")) {
      used.set(0, vertices);
      return used;
    }
    for (int vertex : accessors.vertices(primitive, vertices)) {
      used.set(vertex);
    }
    return used;
  }

  private void warn(GltfJson primitive, String message) {
    document.warnings().add(primitive.location(), message);
  }

  /** Returns the points among the vertices of a primitive, which a pose may have moved. */
  ModelGeometry shown(GltfJson primitive, ModelGeometry all) throws ModelFormatException {
    BitSet others = hidden.get(primitive.location());
    if (others == null) {
      return all;
    }
    ModelGeometry known = shown.get(all);
    if (known == null) {
      document.budget().allocate(primitive.location(), BYTES_PER_VERTEX * all.vertexCount());
      known = all.points(vertex -> !others.get(vertex));
      shown.put(all, known);
    }
    return known;
  }

  /** Returns whether a transform would make ellipsoids of spheres. */
  static boolean isUneven(Transform toWorld) {
    double x = toWorld.vector(Vec3.X).length();
    double y = toWorld.vector(Vec3.Y).length();
    double z = toWorld.vector(Vec3.Z).length();
    return toWorld.isSkewed() || Math.abs(y - x) > ROUNDING * x || Math.abs(z - x) > ROUNDING * x;
  }
}
