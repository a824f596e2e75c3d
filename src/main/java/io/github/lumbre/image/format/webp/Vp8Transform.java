package io.github.lumbre.image.format.webp;

/** The inverse transforms of VP8 (RFC 6386, sec. 14.3 and 14.4). */
final class Vp8Transform {
  private static final int SIDE = 4;

  private Vp8Transform() {}

  /**
   * Transforms the means of 16 blocks with the inverse Walsh-Hadamard transform.
   *
   * @param blocks receives each mean as the first coefficient of a block
   */
  static void spreadMeans(short[] means, short[] blocks) {
    int[] rows = new int[SIDE * SIDE];
    for (int i = 0; i < SIDE; i++) {
      int outer = means[i] + means[12 + i];
      int inner = means[4 + i] + means[8 + i];
      int innerDifference = means[4 + i] - means[8 + i];
      int outerDifference = means[i] - means[12 + i];
      rows[i] = outer + inner;
      rows[4 + i] = outerDifference + innerDifference;
      rows[8 + i] = outer - inner;
      rows[12 + i] = outerDifference - innerDifference;
    }
    for (int i = 0; i < rows.length; i += SIDE) {
      int outer = rows[i] + 3 + rows[i + 3];
      int inner = rows[i + 1] + rows[i + 2];
      int innerDifference = rows[i + 1] - rows[i + 2];
      int outerDifference = rows[i] + 3 - rows[i + 3];
      int block = i * Vp8Coefficients.BLOCK;
      blocks[block] = (short) (outer + inner >> 3);
      blocks[block + 16] = (short) (outerDifference + innerDifference >> 3);
      blocks[block + 32] = (short) (outer - inner >> 3);
      blocks[block + 48] = (short) (outerDifference - innerDifference >> 3);
    }
  }

  /**
   * Adds the inverse cosine transform of a block to a plane.
   *
   * @param from the position of the block's coefficients
   */
  static void add(short[] coefficients, int from, Vp8Plane plane, int x, int y) {
    if (isZero(coefficients, from)) {
      return;
    }
    int[] turned = new int[SIDE * SIDE];
    for (int i = 0; i < SIDE; i++) {
      int at = from + i;
      int sum = coefficients[at] + coefficients[at + 8];
      int difference = coefficients[at] - coefficients[at + 8];
      int sine = sine(coefficients[at + 4]) - cosine(coefficients[at + 12]);
      int cosine = cosine(coefficients[at + 4]) + sine(coefficients[at + 12]);
      turned[4 * i] = sum + cosine;
      turned[4 * i + 1] = difference + sine;
      turned[4 * i + 2] = difference - sine;
      turned[4 * i + 3] = sum - cosine;
    }
    for (int i = 0; i < SIDE; i++) {
      int sum = turned[i] + 4 + turned[8 + i];
      int difference = turned[i] + 4 - turned[8 + i];
      int sine = sine(turned[4 + i]) - cosine(turned[12 + i]);
      int cosine = cosine(turned[4 + i]) + sine(turned[12 + i]);
      int at = plane.at(x, y + i);
      plane.add(at, sum + cosine >> 3);
      plane.add(at + 1, difference + sine >> 3);
      plane.add(at + 2, difference - sine >> 3);
      plane.add(at + 3, sum - cosine >> 3);
    }
  }

  private static boolean isZero(short[] coefficients, int from) {
    for (int i = from; i < from + SIDE * SIDE; i++) {
      if (coefficients[i] != 0) {
        return false;
      }
    }
    return true;
  }

  /** Returns a number times √2 cos(π/8). */
  private static int cosine(int number) {
    return (number * 20091 >> 16) + number;
  }

  /** Returns a number times √2 sin(π/8). */
  private static int sine(int number) {
    return number * 35468 >> 16;
  }
}
