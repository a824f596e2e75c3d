package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.nio.ByteBuffer;

/** How decoded integers become the values of an attribute. */
@FunctionalInterface
interface ValueFormat {
  /** The largest number of bits of a quantized number. */
  int MAX_BITS = 30;

  /**
   * Appends a value.
   *
   * @param values integers; the values from {@code at} on are used
   */
  void put(int[] values, int at, ByteBuffer target);

  /** Returns the format of integers, which are stored as they are. */
  static ValueFormat integers(DracoType type, int components) {
    return (values, at, target) -> {
      for (int c = 0; c < components; c++) {
        type.put(target, values[at + c]);
      }
    };
  }

  /** Reads the range of numbers that are stored as multiples of a step. */
  static ValueFormat readQuantized(DracoInput input, int components) throws ModelFormatException {
    float[] min = new float[components];
    for (int c = 0; c < components; c++) {
      min[c] = input.number();
    }
    float range = input.number();
    int bits = input.unsignedByte();
    if (bits < 1 || bits > MAX_BITS) {
      throw input.malformed("expected 1 to 30 bits per number, found " + bits);
    }
    float step = range / ((1 << bits) - 1);
    return (values, at, target) -> {
      for (int c = 0; c < components; c++) {
        target.putFloat(values[at + c] * step + min[c]);
      }
    };
  }

  /** Reads the number of bits of unit vectors that are stored as {@link Octahedron} coordinates. */
  static ValueFormat readNormals(DracoInput input) throws ModelFormatException {
    Octahedron octahedron = Octahedron.ofBits(input.unsignedByte(), input);
    return (values, at, target) -> octahedron.put(values[at], values[at + 1], target);
  }
}
