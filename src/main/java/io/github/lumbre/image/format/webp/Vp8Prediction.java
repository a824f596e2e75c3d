package io.github.lumbre.image.format.webp;

/** Predicts the samples of blocks from their neighbors (RFC 6386, sec. 12). */
final class Vp8Prediction {
  private static final int SIDE = 4;

  /**
   * The samples of a 4×4 block for each mode after {@link Vp8Modes#TRUE_MOTION}, row by row. The
   * edge has 15 samples: the lowest to the left twice, up to the corner (5), then eight above from
   * left to right, the last one twice. A small letter is the mean of a sample (a: 0) and the next
   * one; a capital is a mean of three, with a double weight of the one in the middle (A: 0).
   */
  private static final String[] DIRECTIONS = {
    "GHIJGHIJGHIJGHIJ",
    "EEEEDDDDCCCCBBBB",
    "FGHIEFGHDEFGCDEF",
    "fghiFGHIEfghDFGH",
    "HIJKIJKLJKLMKLMN",
    "ghijHIJKhijLIJKM",
    "eFGHdEeFcDdEbCcD",
    "dDcCcCbBbBaaaaaa"
  };

  private final int[] edge = new int[15];

  /**
   * Predicts a square of 8 or 16 samples a side.
   *
   * @param mode one of the constants of {@link Vp8Modes}
   */
  static void predict(Vp8Plane plane, int x, int y, int side, int mode) {
    if (mode == Vp8Modes.DC) {
      fill(plane, x, y, side, mean(plane, x, y, side));
      return;
    }
    int corner = plane.get(plane.at(x - 1, y - 1));
    int above = plane.at(x, y - 1);
    for (int row = 0; row < side; row++) {
      int left = plane.get(plane.at(x - 1, y + row));
      int at = plane.at(x, y + row);
      for (int i = 0; i < side; i++) {
        plane.set(
            at + i,
            mode == Vp8Modes.HORIZONTAL
                ? left
                : plane.get(above + i) + (mode == Vp8Modes.VERTICAL ? 0 : left - corner));
      }
    }
  }

  /** Returns the mean of the neighbors that are in the picture, or 128 if there are none. */
  private static int mean(Vp8Plane plane, int x, int y, int side) {
    int sum = 0;
    int count = (x > 0 ? side : 0) + (y > 0 ? side : 0);
    for (int i = 0; i < side; i++) {
      sum += x > 0 ? plane.get(plane.at(x - 1, y + i)) : 0;
      sum += y > 0 ? plane.get(plane.at(x + i, y - 1)) : 0;
    }
    return count == 0 ? 128 : (sum + count / 2) / count;
  }

  private static void fill(Vp8Plane plane, int x, int y, int side, int value) {
    for (int row = 0; row < side; row++) {
      int at = plane.at(x, y + row);
      for (int i = 0; i < side; i++) {
        plane.set(at + i, value);
      }
    }
  }

  /**
   * Predicts a block of 4×4 samples.
   *
   * @param mode from 0 to 9
   * @param right the position of the four samples above and to the right of the block
   * @param step the distance of these samples, 0 if they are the same
   */
  void predictBlock(Vp8Plane plane, int x, int y, int mode, int right, int step) {
    if (mode == Vp8Modes.TRUE_MOTION) {
      predict(plane, x, y, SIDE, mode);
      return;
    }
    readEdge(plane, x, y, right, step);
    if (mode == Vp8Modes.DC) {
      int sum = SIDE;
      for (int i = 1; i <= SIDE; i++) {
        sum += edge[i] + edge[5 + i];
      }
      fill(plane, x, y, SIDE, sum / (2 * SIDE));
      return;
    }
    String direction = DIRECTIONS[mode - Vp8Modes.VERTICAL];
    for (int i = 0; i < SIDE * SIDE; i++) {
      plane.set(plane.at(x + i % SIDE, y + i / SIDE), smoothed(direction.charAt(i)));
    }
  }

  private int smoothed(char letter) {
    if (letter >= 'a') {
      int i = letter - 'a';
      return edge[i] + edge[i + 1] + 1 >> 1;
    }
    int i = letter - 'A';
    return edge[i - 1] + 2 * edge[i] + edge[i + 1] + 2 >> 2;
  }

  private void readEdge(Vp8Plane plane, int x, int y, int right, int step) {
    for (int i = 0; i < SIDE; i++) {
      edge[1 + i] = plane.get(plane.at(x - 1, y + SIDE - 1 - i));
      edge[6 + i] = plane.get(plane.at(x + i, y - 1));
      edge[10 + i] = plane.get(right + step * i);
    }
    edge[0] = edge[1];
    edge[5] = plane.get(plane.at(x - 1, y - 1));
    edge[14] = edge[13];
  }
}
