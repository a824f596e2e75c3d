package io.github.lumbre.image.format.webp;

/**
 * Smooths the samples at an edge of blocks (RFC 6386, sec. 15.2 and 15.3). The samples are p3 to p0
 * before the edge, and q0 to q3 after it.
 *
 * @param limit of the difference across the edge above which it is no artifact
 * @param interior the limit of the differences beside the edge
 * @param variance the difference beside the edge above which only p0 and q0 are changed
 * @param isOuter whether the edge is one of a macroblock
 */
record Vp8Edge(int limit, int interior, int variance, boolean isOuter) {
  /** Changes p0 and q0, with the simple filter. */
  void smoothSimply(Vp8Plane plane, int at, int step) {
    if (isArtifact(plane, at, step)) {
      smoothTwo(plane, at, step);
    }
  }

  /**
   * Changes up to six samples.
   *
   * @param at the position of q0
   * @param step the distance of neighboring positions
   */
  void smooth(Vp8Plane plane, int at, int step) {
    if (!isArtifact(plane, at, step) || !isSmooth(plane, at, step)) {
      return;
    }
    boolean isVaried =
        difference(plane, at - 2 * step, at - step) > variance
            || difference(plane, at + step, at) > variance;
    if (isVaried) {
      smoothTwo(plane, at, step);
    } else if (isOuter) {
      smoothSix(plane, at, step);
    } else {
      smoothFour(plane, at, step);
    }
  }

  private boolean isArtifact(Vp8Plane plane, int at, int step) {
    return 4 * difference(plane, at - step, at) + difference(plane, at - 2 * step, at + step)
        <= limit;
  }

  private boolean isSmooth(Vp8Plane plane, int at, int step) {
    for (int i = 1; i < 4; i++) {
      if (difference(plane, at - (i + 1) * step, at - i * step) > interior
          || difference(plane, at + i * step, at + (i - 1) * step) > interior) {
        return false;
      }
    }
    return true;
  }

  private static int difference(Vp8Plane plane, int first, int second) {
    return Math.abs(plane.get(first) - plane.get(second));
  }

  private static void smoothTwo(Vp8Plane plane, int at, int step) {
    int change = change(plane, at, step) + signed(plane.get(at - 2 * step) - plane.get(at + step));
    plane.add(at - step, eighth(change + 3));
    plane.add(at, -eighth(change + 4));
  }

  private static void smoothFour(Vp8Plane plane, int at, int step) {
    int change = change(plane, at, step);
    int after = eighth(change + 4);
    int outside = after + 1 >> 1;
    plane.add(at - 2 * step, outside);
    plane.add(at - step, eighth(change + 3));
    plane.add(at, -after);
    plane.add(at + step, -outside);
  }

  private static void smoothSix(Vp8Plane plane, int at, int step) {
    int change =
        signed(change(plane, at, step) + signed(plane.get(at - 2 * step) - plane.get(at + step)));
    for (int i = 0; i < 3; i++) {
      int part = (27 - 9 * i) * change + 63 >> 7;
      plane.add(at - (i + 1) * step, part);
      plane.add(at + i * step, -part);
    }
  }

  /** Returns three times the step from p0 to q0. */
  private static int change(Vp8Plane plane, int at, int step) {
    return 3 * (plane.get(at) - plane.get(at - step));
  }

  /** Returns the nearest number that fits into a signed byte. */
  private static int signed(int value) {
    return Math.max(-128, Math.min(127, value));
  }

  /** Returns an eighth of the nearest number that fits into a signed byte. */
  private static int eighth(int value) {
    return signed(value) >> 3;
  }
}
