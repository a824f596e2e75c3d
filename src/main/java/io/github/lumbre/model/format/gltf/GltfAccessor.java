package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelLimits;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A typed list of elements in the buffers of a glTF file (glTF 2.0, section 3.6.2), whose bounds
 * are checked.
 */
final class GltfAccessor {
  private static final List<String> TYPES =
      List.of("SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4");
  private static final int[] COMPONENTS = {1, 2, 3, 4, 4, 9, 16};

  private final String location;
  private final GltfComponent component;
  private final int components;
  private final int count;
  private final boolean normalized;
  private final Optional<Source> source;
  private final Optional<Sparse> sparse;

  /** Where elements are stored. */
  private record Source(ByteBuffer bytes, int offset, int stride) {}

  /** Elements that replace elements of the buffer view. */
  private record Sparse(int[] indices, Source values) {}

  private GltfAccessor(GltfJson json, GltfDocument document, GltfBuffers buffers)
      throws ModelFormatException, IOException {
    location = json.location();
    component = GltfComponent.of(json, "componentType");
    components = components(json);
    normalized = json.flag("normalized", false);
    long found = json.requireWhole("count", 0, Long.MAX_VALUE);
    ModelLimits.require(json.location("count"), "elements", GltfBudget.MAX_COUNT, found);
    count = (int) found;
    if (json.has("bufferView")) {
      source = Optional.of(source(json, buffers, component, components, count));
    } else {
      source = Optional.empty();
      ModelLimits.require(
          json.location("count"), "elements without a bufferView", GltfBudget.MAX_ZEROS, found);
    }
    Optional<GltfJson> differences = json.object("sparse");
    sparse =
        differences.isPresent()
            ? Optional.of(sparse(differences.get(), document, buffers))
            : Optional.empty();
  }

  private GltfAccessor(
      String location, GltfComponent component, int components, boolean normalized, Source source) {
    this.location = location;
    this.component = component;
    this.components = components;
    this.normalized = normalized;
    this.source = Optional.of(source);
    sparse = Optional.empty();
    count = source.bytes.limit() / source.stride;
  }

  /**
   * Returns an accessor of elements without gaps.
   *
   * @param location in the file, for messages
   * @param bytes all elements, little-endian
   */
  static GltfAccessor over(
      ByteBuffer bytes,
      GltfComponent component,
      int components,
      boolean normalized,
      String location) {
    Source source = new Source(bytes, 0, component.size() * components);
    return new GltfAccessor(location, component, components, normalized, source);
  }

  /**
   * Returns the accessor that a JSON object describes.
   *
   * @throws ModelFormatException if its elements exceed their buffer view
   */
  static GltfAccessor of(GltfJson json, GltfDocument document, GltfBuffers buffers)
      throws ModelFormatException, IOException {
    Interrupts.check();
    return new GltfAccessor(json, document, buffers);
  }

  /** Returns the number of numbers per element of the accessor that a JSON object describes. */
  static int components(GltfJson json) throws ModelFormatException {
    return COMPONENTS[TYPES.indexOf(json.choice("type", "", TYPES))];
  }

  private static Source source(
      GltfJson json, GltfBuffers buffers, GltfComponent component, int components, int count)
      throws ModelFormatException, IOException {
    GltfBuffers.View view = buffers.view(json);
    int size = component.size() * components;
    int stride = view.stride() == 0 ? size : view.stride();
    if (stride < size) {
      throw json.malformed(
          "bufferView", "expected a byteStride of at least " + size + ", found " + stride);
    }
    int room = view.bytes().limit();
    int offset = (int) json.whole("byteOffset", 0, 0, room);
    long needed = count == 0 ? 0 : offset + (long) stride * (count - 1) + size;
    if (needed > room) {
      throw json.malformed("bufferView", "expected at least " + needed + " bytes, found " + room);
    }
    return new Source(view.bytes(), offset, stride);
  }

  private Sparse sparse(GltfJson json, GltfDocument document, GltfBuffers buffers)
      throws ModelFormatException, IOException {
    int changed = (int) json.requireWhole("count", 0, count);
    GltfJson indices = json.requireObject("indices");
    GltfComponent type = GltfComponent.of(indices, "componentType");
    if (!type.isUnsigned()) {
      throw indices.expected("componentType", "5121, 5123 or 5125");
    }
    Source places = source(indices, buffers, type, 1, changed);
    Source values = source(json.requireObject("values"), buffers, component, components, changed);
    document.budget().allocate(json.location(), (long) Integer.BYTES * changed);
    int[] at = new int[changed];
    type.readIndices(places.bytes, places.offset, places.stride, changed, at, 0);
    for (int i = 0; i < changed; i++) {
      if (at[i] < 0 || at[i] >= count || i > 0 && at[i] <= at[i - 1]) {
        throw Kind.MALFORMED.at(
            indices.location(),
            "expected increasing numbers from 0 to %s, found %s at %s"
                .formatted(count - 1, Integer.toUnsignedString(at[i]), i));
      }
    }
    return new Sparse(at, values);
  }

  /** Returns the place in the file. */
  String location() {
    return location;
  }

  /** Returns the number of elements. */
  int count() {
    return count;
  }

  /** Returns the number of numbers per element. */
  int components() {
    return components;
  }

  /** Returns the type of the numbers. */
  GltfComponent component() {
    return component;
  }

  /** Checks that elements have a number of components. */
  GltfAccessor requireComponents(int expected) throws ModelFormatException {
    if (components != expected) {
      throw error("type", "expected " + expected + " numbers per element, found " + components);
    }
    return this;
  }

  /** Checks that there are at least as many elements. */
  GltfAccessor requireAtLeast(long expected) throws ModelFormatException {
    if (count < expected) {
      throw error("count", "expected at least " + expected + ", found " + count);
    }
    return this;
  }

  /** Reads all elements as numbers, normalized if the accessor states so. */
  void read(double[] target) {
    read(target, normalized);
  }

  /** Reads all elements as numbers, integers as fractions of their largest value. */
  void readNormalized(double[] target) {
    read(target, true);
  }

  private void read(double[] target, boolean fractions) {
    int length = count * components;
    if (source.isPresent()) {
      Source s = source.get();
      component.read(s.bytes, s.offset, s.stride, count, components, target, 0);
    } else {
      Arrays.fill(target, 0, length, 0);
    }
    if (sparse.isPresent()) {
      int[] at = sparse.get().indices;
      Source s = sparse.get().values;
      for (int i = 0; i < at.length; i++) {
        int from = s.offset + i * s.stride;
        component.read(s.bytes, from, s.stride, 1, components, target, components * at[i]);
      }
    }
    if (fractions) {
      component.normalize(target, 0, length);
    }
  }

  /**
   * Reads elements of one unsigned integer each.
   *
   * @param target receives values above 2^31 - 1 as negative numbers
   */
  void readIndices(int[] target) {
    if (source.isPresent()) {
      Source s = source.get();
      component.readIndices(s.bytes, s.offset, s.stride, count, target, 0);
    } else {
      Arrays.fill(target, 0, count, 0);
    }
    if (sparse.isPresent()) {
      int[] at = sparse.get().indices;
      Source s = sparse.get().values;
      for (int i = 0; i < at.length; i++) {
        component.readIndices(s.bytes, s.offset + i * s.stride, s.stride, 1, target, at[i]);
      }
    }
  }

  ModelFormatException error(String member, String message) {
    return Kind.MALFORMED.at(member.isEmpty() ? location : location + '.' + member, message);
  }
}
