package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;

/** The types of the numbers in an accessor (glTF 2.0, section 3.6.2.2). */
enum GltfComponent {
  BYTE(5120, 1, 127),
  UNSIGNED_BYTE(5121, 1, 255),
  SHORT(5122, 2, 32767),
  UNSIGNED_SHORT(5123, 2, 65535),
  UNSIGNED_INT(5125, 4, 4294967295.0),
  FLOAT(5126, 4, 1);

  /** Floats that are read at once. */
  private static final int BLOCK = 4096;

  private final int code;
  private final int size;
  private final double largest;

  GltfComponent(int code, int size, double largest) {
    this.code = code;
    this.size = size;
    this.largest = largest;
  }

  /** Returns the type of a member that is its code in the file. */
  static GltfComponent of(GltfJson json, String member) throws ModelFormatException {
    double code = json.number(member, 0);
    for (GltfComponent type : values()) {
      if (code == type.code) {
        return type;
      }
    }
    throw json.expected(member, "5120 to 5123, 5125 or 5126");
  }

  /** Returns the number of bytes. */
  int size() {
    return size;
  }

  /** Returns whether values are unsigned integers. */
  boolean isUnsigned() {
    return this == UNSIGNED_BYTE || this == UNSIGNED_SHORT || this == UNSIGNED_INT;
  }

  /**
   * Reads elements as doubles.
   *
   * @param offset of the first element
   * @param stride bytes from one element to the next
   * @param components numbers per element
   * @param to the first index in the target
   */
  void read(
      ByteBuffer bytes,
      int offset,
      int stride,
      int count,
      int components,
      double[] target,
      int to) {
    switch (this) {
      case FLOAT -> readFloats(bytes, offset, stride, count, components, target, to);
      case UNSIGNED_SHORT -> readShorts(bytes, offset, stride, count, components, target, to);
      default -> readOthers(bytes, offset, stride, count, components, target, to);
    }
  }

  // One loop for each frequent type, so that the compiler can unroll it.

  private static void readFloats(
      ByteBuffer bytes, int at, int stride, int count, int components, double[] target, int to) {
    if (stride == Float.BYTES * components && count > 1) {
      readAdjacentFloats(bytes, at, count * components, target, to);
      return;
    }
    for (int i = 0; i < count; i++) {
      for (int c = 0; c < components; c++) {
        target[to + c] = bytes.getFloat(at + 4 * c);
      }
      at += stride;
      to += components;
    }
  }

  private static void readAdjacentFloats(
      ByteBuffer bytes, int at, int length, double[] target, int to) {
    FloatBuffer floats = bytes.slice(at, Float.BYTES * length).order(bytes.order()).asFloatBuffer();
    float[] block = new float[Math.min(BLOCK, length)];
    for (int done = 0; done < length; done += block.length) {
      int count = Math.min(block.length, length - done);
      floats.get(block, 0, count);
      for (int i = 0; i < count; i++) {
        target[to + done + i] = block[i];
      }
    }
  }

  private static void readShorts(
      ByteBuffer bytes, int at, int stride, int count, int components, double[] target, int to) {
    for (int i = 0; i < count; i++) {
      for (int c = 0; c < components; c++) {
        target[to + c] = bytes.getShort(at + 2 * c) & 0xffff;
      }
      at += stride;
      to += components;
    }
  }

  private void readOthers(
      ByteBuffer bytes, int at, int stride, int count, int components, double[] target, int to) {
    for (int i = 0; i < count; i++) {
      for (int c = 0; c < components; c++) {
        target[to + c] = value(bytes, at + size * c);
      }
      at += stride;
      to += components;
    }
  }

  private double value(ByteBuffer bytes, int at) {
    return switch (this) {
      case BYTE -> bytes.get(at);
      case UNSIGNED_BYTE -> bytes.get(at) & 0xff;
      case SHORT -> bytes.getShort(at);
      case UNSIGNED_SHORT -> bytes.getShort(at) & 0xffff;
      case UNSIGNED_INT -> Integer.toUnsignedLong(bytes.getInt(at));
      case FLOAT -> bytes.getFloat(at);
    };
  }

  /**
   * Reads elements of one unsigned integer each.
   *
   * @param target receives values above 2^31 - 1 as negative numbers
   */
  void readIndices(ByteBuffer bytes, int at, int stride, int count, int[] target, int to) {
    switch (this) {
      case UNSIGNED_BYTE -> {
        for (int i = 0; i < count; i++) {
          target[to + i] = bytes.get(at + i * stride) & 0xff;
        }
      }
      case UNSIGNED_SHORT -> {
        for (int i = 0; i < count; i++) {
          target[to + i] = bytes.getShort(at + i * stride) & 0xffff;
        }
      }
      default -> {
        if (stride == Integer.BYTES) {
          bytes.slice(at, stride * count).order(bytes.order()).asIntBuffer().get(target, to, count);
          return;
        }
        for (int i = 0; i < count; i++) {
          target[to + i] = bytes.getInt(at + i * stride);
        }
      }
    }
  }

  /** Maps integers to [0,1] or [-1,1] (glTF 2.0, section 3.6.2.2); does nothing to floats. */
  void normalize(double[] values, int from, int to) {
    if (this == FLOAT) {
      return;
    }
    for (int i = from; i < to; i++) {
      values[i] = Math.max(values[i] / largest, -1);
    }
  }
}
