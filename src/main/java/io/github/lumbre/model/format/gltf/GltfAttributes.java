package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import java.io.IOException;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;

/**
 * Reads the vertex attributes of meshes. Primitives that use one accessor share one array. Mutable.
 */
final class GltfAttributes {
  private final GltfDocument document;
  private final GltfAccessors accessors;
  private final Map<GltfAccessor, BitSet> broken = new HashMap<>();
  private final Map<Map.Entry<GltfAccessor, Role>, double[]> arrays = new HashMap<>();
  private final Map<GltfAccessor, float[]> colors = new HashMap<>();

  /** The meanings of numbers. */
  private enum Role {
    POSITION(3),
    NORMAL(3),
    TANGENT(4),
    UV(2);

    private final int components;

    Role(int components) {
      this.components = components;
    }
  }

  GltfAttributes(GltfDocument document, GltfAccessors accessors) {
    this.document = document;
    this.accessors = accessors;
  }

  /** Returns positions; {@link #broken} vertices are at 0. */
  double[] positions(GltfAccessor accessor) throws ModelFormatException {
    double[] array = arrays.get(Map.entry(accessor, Role.POSITION));
    if (array == null) {
      document.budget().addVertices(accessor.location(), accessor.count());
      array = accessors.numbers(accessor.requireComponents(3));
      broken.put(accessor, GltfVectors.removeBroken(array));
      arrays.put(Map.entry(accessor, Role.POSITION), array);
    }
    return array;
  }

  /** Returns the vertices of positions, already read, that are not finite. */
  BitSet broken(GltfAccessor accessor) {
    return broken.get(accessor);
  }

  /** Returns unit normals; none if one is not finite. */
  double[] normals(GltfJson attributes, int vertices) throws ModelFormatException, IOException {
    return optional(attributes, "NORMAL", vertices, Role.NORMAL);
  }

  /**
   * Returns unit tangents and the signs of bitangents; none if one is not finite.
   *
   * <p>The signs stay although v is flipped: normal maps of glTF have +Y up (section 3.9.3), so
   * their bitangents point to the upper edge of the picture, where v is 1 here.
   */
  double[] tangents(GltfJson attributes, int vertices) throws ModelFormatException, IOException {
    return optional(attributes, "TANGENT", vertices, Role.TANGENT);
  }

  /** Returns texture coordinates, with v = 0 at the lower edge; none if one is not finite. */
  double[] uvs(GltfJson attributes, String name, int vertices)
      throws ModelFormatException, IOException {
    return optional(attributes, name, vertices, Role.UV);
  }

  private double[] optional(GltfJson attributes, String name, int vertices, Role role)
      throws ModelFormatException, IOException {
    if (!attributes.has(name)) {
      return new double[0];
    }
    GltfAccessor accessor = of(attributes, name, vertices).requireComponents(role.components);
    double[] array = arrays.get(Map.entry(accessor, role));
    if (array == null) {
      array = converted(accessors.numbers(accessor), accessor, role);
      if (GltfAccessors.indexOfInfinite(array) >= 0) {
        document
            .warnings()
            .add(accessor.location(), "NaN or infinite numbers; " + name + " is ignored");
        array = new double[0];
      }
      arrays.put(Map.entry(accessor, role), array);
    }
    return array;
  }

  private static double[] converted(double[] numbers, GltfAccessor accessor, Role role) {
    if (role == Role.UV) {
      for (int i = 1; i < numbers.length; i += 2) {
        numbers[i] = 1 - numbers[i];
      }
    } else if (accessor.component() != GltfComponent.FLOAT) {
      // Integers are rounded directions.
      GltfVectors.normalize(numbers, accessor.components());
    }
    return numbers;
  }

  /** Returns linear colors with opacity, in [0,1]; none if there are none. */
  float[] colors(GltfJson attributes, int vertices) throws ModelFormatException, IOException {
    if (!attributes.has("COLOR_0")) {
      return new float[0];
    }
    GltfAccessor accessor = of(attributes, "COLOR_0", vertices);
    float[] found = colors.get(accessor);
    if (found == null) {
      int components = accessor.components();
      if (components != 3) {
        accessor.requireComponents(4);
      }
      document.budget().allocate(accessor.location(), 4L * Float.BYTES * vertices);
      found = opaque(accessors.fractions(accessor), components);
      colors.put(accessor, found);
    }
    return found;
  }

  private static float[] opaque(double[] numbers, int components) {
    int count = numbers.length / components;
    float[] colors = new float[4 * count];
    for (int i = 0; i < count; i++) {
      for (int c = 0; c < 4; c++) {
        double number = c < components ? numbers[components * i + c] : 1;
        // NaN becomes 0.
        colors[4 * i + c] = number > 0 ? (float) Math.min(number, 1) : 0;
      }
    }
    return colors;
  }

  /** Returns the accessor of an attribute, with one element per vertex. */
  GltfAccessor of(GltfJson attributes, String name, int vertices)
      throws ModelFormatException, IOException {
    GltfAccessor accessor = accessors.require(attributes, name);
    if (accessor.count() != vertices) {
      throw attributes.malformed(
          name, "expected " + vertices + " elements, as POSITION has, found " + accessor.count());
    }
    return accessor;
  }
}
