package io.github.lumbre.model.format.meshopt;

import java.nio.ByteBuffer;

/** How elements were changed before they were compressed as attributes. */
public enum MeshoptFilter {
  /** Not at all. */
  NONE,
  /** Unit vectors and a fourth number, of 8 or 16 bits. */
  OCTAHEDRAL,
  /** Unit quaternions, of 16 bits. */
  QUATERNION,
  /** 32-bit floats. */
  EXPONENTIAL,
  /** Colors with alpha, of 8 or 16 bits. */
  COLOR;

  private static final int COMPONENTS = 4;
  private static final float SHORT_ONE = Short.MAX_VALUE;

  /** Returns whether elements can have a number of bytes. */
  public boolean fits(int stride) {
    return switch (this) {
      case NONE, EXPONENTIAL -> true;
      case OCTAHEDRAL, COLOR -> stride == COMPONENTS || stride == COMPONENTS * Short.BYTES;
      case QUATERNION -> stride == COMPONENTS * Short.BYTES;
    };
  }

  /**
   * Restores elements in place. Elements without a meaning become unspecified ones.
   *
   * @param elements little-endian
   * @param stride bytes per element, which {@link #fits}
   */
  public void restore(ByteBuffer elements, int stride) {
    int step = this == EXPONENTIAL ? Float.BYTES : stride;
    for (int at = 0; this != NONE && at < elements.limit(); at += step) {
      switch (this) {
        case OCTAHEDRAL -> restoreVector(elements, at, stride / COMPONENTS);
        case QUATERNION -> restoreQuaternion(elements, at);
        case EXPONENTIAL -> restoreFloat(elements, at);
        default -> restoreColor(elements, at, stride / COMPONENTS);
      }
    }
  }

  /** Unfolds a point of an octahedron; the third number is the distance of its corners. */
  private static void restoreVector(ByteBuffer elements, int at, int size) {
    float x = get(elements, at, size);
    float y = get(elements, at + size, size);
    float z = get(elements, at + 2 * size, size) - Math.abs(x) - Math.abs(y);
    float fold = Math.min(z, 0);
    x += x < 0 ? -fold : fold;
    y += y < 0 ? -fold : fold;
    float one = size == 1 ? Byte.MAX_VALUE : SHORT_ONE;
    float scale = one / (float) Math.sqrt(x * x + y * y + z * z);
    put(elements, at, size, x * scale);
    put(elements, at + size, size, y * scale);
    put(elements, at + 2 * size, size, z * scale);
  }

  /**
   * Computes the largest component, whose index is in the lowest two bits of the last number. The
   * components that follow it, in cyclic order, are stored as multiples of sqrt(1/2).
   */
  private static void restoreQuaternion(ByteBuffer elements, int at) {
    int last = get(elements, at + 3 * Short.BYTES, Short.BYTES);
    float scale = (float) Math.sqrt(.5) / (last | 3);
    float x = get(elements, at, Short.BYTES) * scale;
    float y = get(elements, at + Short.BYTES, Short.BYTES) * scale;
    float z = get(elements, at + 2 * Short.BYTES, Short.BYTES) * scale;
    float w = (float) Math.sqrt(Math.max(0, 1 - (x * x + y * y + z * z)));
    float[] rotated = {w, x, y, z};
    for (int i = 0; i < COMPONENTS; i++) {
      int component = last + i & 3;
      put(elements, at + component * Short.BYTES, Short.BYTES, rotated[i] * SHORT_ONE);
    }
  }

  /** Converts an exponent of 8 bits and a mantissa of 24 bits. */
  private static void restoreFloat(ByteBuffer elements, int at) {
    int bits = elements.getInt(at);
    elements.putFloat(at, Math.scalb((float) (bits << 8 >> 8), bits >> 24));
  }

  /** Converts YCoCg and alpha; the highest bit of alpha tells the number of bits of all numbers. */
  private static void restoreColor(ByteBuffer elements, int at, int size) {
    int mask = size == 1 ? 0xff : 0xffff;
    int y = get(elements, at, size) & mask;
    int co = get(elements, at + size, size);
    int cg = get(elements, at + 2 * size, size);
    int alpha = get(elements, at + 3 * size, size) & mask;
    int most = (Integer.highestOneBit(alpha) << 1) - 1;
    int low = alpha & most >> 1;
    float scale = mask / (float) most;
    put(elements, at, size, (y + co - cg) * scale);
    put(elements, at + size, size, (y + cg) * scale);
    put(elements, at + 2 * size, size, (y - co - cg) * scale);
    put(elements, at + 3 * size, size, (low << 1 | low & 1) * scale);
  }

  private static int get(ByteBuffer elements, int at, int size) {
    return size == 1 ? elements.get(at) : elements.getShort(at);
  }

  /** Stores the nearest integer, of two the even one, as meshoptimizer does. */
  private static void put(ByteBuffer elements, int at, int size, float number) {
    int rounded = (int) Math.rint(number);
    if (size == 1) {
      elements.put(at, (byte) rounded);
    } else {
      elements.putShort(at, (short) rounded);
    }
  }
}
