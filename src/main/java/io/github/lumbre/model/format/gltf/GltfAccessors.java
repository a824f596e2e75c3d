package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;

/** The accessors of a glTF file, checked when first used. Mutable. */
final class GltfAccessors {
  private final GltfDocument document;
  private final GltfBuffers buffers;
  private final Map<Integer, GltfAccessor> accessors = new HashMap<>();
  private final Map<String, GltfAccessor> replaced = new HashMap<>();

  GltfAccessors(GltfDocument document, GltfBuffers buffers) {
    this.document = document;
    this.buffers = buffers;
  }

  /**
   * Returns the accessor whose index a member of an object is, and that must exist; or the one that
   * replaces it.
   */
  GltfAccessor require(GltfJson object, String member) throws ModelFormatException, IOException {
    GltfAccessor replacement = replaced.get(path(object, member));
    return replacement == null
        ? get(document.requireIndex(object, member, "accessors"))
        : replacement;
  }

  /** Replaces the accessor whose index a member of an object is. */
  void replace(GltfJson object, String member, GltfAccessor replacement) {
    replaced.put(path(object, member), replacement);
  }

  private static String path(GltfJson object, String member) {
    return object.value().path() + '.' + member;
  }

  GltfAccessor get(int index) throws ModelFormatException, IOException {
    GltfAccessor accessor = accessors.get(index);
    if (accessor == null) {
      accessor = GltfAccessor.of(document.section("accessors").get(index), document, buffers);
      accessors.put(index, accessor);
    }
    return accessor;
  }

  /**
   * Returns all numbers of an accessor, in a new array.
   *
   * @throws ModelFormatException if one is not finite
   */
  double[] finiteNumbers(GltfAccessor accessor) throws ModelFormatException {
    double[] numbers = numbers(accessor);
    int bad = indexOfInfinite(numbers);
    if (bad >= 0) {
      throw accessor.error(
          "",
          "expected finite numbers, found %s in element %s"
              .formatted(numbers[bad], bad / accessor.components()));
    }
    return numbers;
  }

  /** Returns all numbers of an accessor, in a new array. */
  double[] numbers(GltfAccessor accessor) throws ModelFormatException {
    double[] numbers = allocate(accessor);
    accessor.read(numbers);
    return numbers;
  }

  /** Returns all numbers of an accessor, integers as fractions of their largest value. */
  double[] fractions(GltfAccessor accessor) throws ModelFormatException {
    double[] numbers = allocate(accessor);
    accessor.readNormalized(numbers);
    return numbers;
  }

  /**
   * Returns the vertices that the indices of a primitive name.
   *
   * @param vertices their number
   */
  int[] vertices(GltfJson primitive, int vertices) throws ModelFormatException, IOException {
    GltfAccessor indices = require(primitive, "indices").requireComponents(1);
    if (!indices.component().isUnsigned()) {
      throw indices.error("componentType", "expected 5121, 5123 or 5125 for indices");
    }
    document.budget().allocate(primitive.location(), (long) Integer.BYTES * indices.count());
    int[] read = new int[indices.count()];
    indices.readIndices(read);
    requireVertices(primitive, read, vertices);
    return read;
  }

  private static void requireVertices(GltfJson primitive, int[] indices, int vertices)
      throws ModelFormatException {
    for (int index : indices) {
      if (index < 0 || index >= vertices) {
        throw primitive.malformed(
            "indices",
            "expected vertices from 0 to %s, found %s"
                .formatted(vertices - 1, Integer.toUnsignedString(index)));
      }
    }
  }

  private double[] allocate(GltfAccessor accessor) throws ModelFormatException {
    Interrupts.check();
    long length = (long) accessor.count() * accessor.components();
    document.budget().allocate(accessor.location(), Double.BYTES * length);
    // MAX_COUNT elements of a 4×4 matrix would not fit into an array.
    ModelLimits.require(accessor.location(), "numbers", 4 * GltfBudget.MAX_COUNT, length);
    return new double[(int) length];
  }

  /** Returns the index of the first number that is not finite; -1 if there is none. */
  static int indexOfInfinite(double[] numbers) {
    for (int i = 0; i < numbers.length; i++) {
      if (!Double.isFinite(numbers[i])) {
        return i;
      }
    }
    return -1;
  }
}
