package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.nio.ByteBuffer;

/**
 * Coordinates of unit vectors on an octahedron that is unfolded to a square: its half with x ≥ 0 is
 * the diamond in the middle. Both coordinates are integers in [0, 2 center].
 *
 * <p>Source: Q. Meyer et al., On Floating-Point Normal Vectors, 2010; Draco specification, Normal
 * Prediction Decoder.
 *
 * @param center the coordinates of the vector (1, 0, 0)
 */
record Octahedron(int center) {
  private static final int MIN_BITS = 2;

  /** Returns the coordinates of a number of bits. */
  static Octahedron ofBits(int bits, DracoInput input) throws ModelFormatException {
    if (bits < MIN_BITS || bits > ValueFormat.MAX_BITS) {
      throw input.malformed("expected normals of 2 to 30 bits, found " + bits);
    }
    return new Octahedron((1 << bits - 1) - 1);
  }

  /** Returns the largest coordinate. */
  int max() {
    return 2 * center;
  }

  /** Appends the unit vector of two coordinates as floats. */
  void put(int s, int t, ByteBuffer target) {
    float scale = 2f / max();
    float y = s * scale - 1;
    float z = t * scale - 1;
    float x = 1 - Math.abs(y) - Math.abs(z);
    float fold = Math.max(0, -x);
    y += y < 0 ? fold : -fold;
    z += z < 0 ? fold : -fold;
    // The length is at least 1/√3.
    float factor = 1 / (float) Math.sqrt(x * x + y * y + z * z);
    target.putFloat(x * factor).putFloat(y * factor).putFloat(z * factor);
  }

  /**
   * Projects a vector to the octahedron |x| + |y| + |z| = center.
   *
   * @param vector three numbers, which are replaced
   */
  void project(int... vector) {
    long sum = Math.abs((long) vector[0]) + Math.abs((long) vector[1]) + Math.abs((long) vector[2]);
    if (sum == 0) {
      vector[0] = center;
      return;
    }
    vector[0] = (int) ((long) vector[0] * center / sum);
    vector[1] = (int) ((long) vector[1] * center / sum);
    int rest = center - Math.abs(vector[0]) - Math.abs(vector[1]);
    vector[2] = vector[2] >= 0 ? rest : -rest;
  }

  /**
   * Converts a vector of the octahedron to coordinates. On the border, two points stand for the
   * same vector; the encoder chooses one of them, but {@link OctahedralCorrection} treats both
   * alike.
   *
   * @param vector integers; |x| + |y| + |z| is the center
   * @param target receives two coordinates
   */
  void unfold(int[] vector, int[] target) {
    int y = vector[1];
    int z = vector[2];
    int s = y + center;
    int t = z + center;
    if (vector[0] < 0) {
      s = y < 0 ? Math.abs(z) : max() - Math.abs(z);
      t = z < 0 ? Math.abs(y) : max() - Math.abs(y);
    }
    target[0] = s;
    target[1] = t;
  }
}
