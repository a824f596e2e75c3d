package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/**
 * Corrections of {@link Octahedron} coordinates. The prediction is turned into one quarter of the
 * diamond in the middle; the correction is added, and the result turned back (Draco specification,
 * Prediction Normal Transform).
 *
 * @param octahedron the coordinates
 */
record OctahedralCorrection(Octahedron octahedron) implements Correction {
  /** Reads the range of the coordinates. */
  static OctahedralCorrection read(DracoInput input) throws ModelFormatException {
    int max = input.integer();
    // The center follows from the maximum.
    input.integer();
    if (max <= 0 || max % 2 == 0) {
      throw input.malformed("expected an odd number of coordinates, found " + max);
    }
    return new OctahedralCorrection(
        Octahedron.ofBits(Integer.SIZE - Integer.numberOfLeadingZeros(max), input));
  }

  @Override
  public void apply(int[] predicted, int from, int[] values, int at) {
    int center = octahedron.center();
    int s = predicted[from] - center;
    int t = predicted[from + 1] - center;
    boolean isOutside = Math.abs(s) + Math.abs(t) > center;
    if (isOutside) {
      int flipped = flip(s, t);
      t = flip(t, s);
      s = flipped;
    }
    int turns = turns(s, t);
    int u = wrapped(turned(s, t, turns) + values[at]);
    int v = wrapped(turned(t, -s, turns) + values[at + 1]);
    int back = (4 - turns) % 4;
    s = turned(u, v, back);
    t = turned(v, -u, back);
    if (isOutside) {
      int flipped = flip(s, t);
      t = flip(t, s);
      s = flipped;
    }
    values[at] = s + center;
    values[at + 1] = t + center;
  }

  /** Returns the first of two coordinates after the swap of a corner triangle and the diamond. */
  private int flip(int s, int t) {
    boolean isPositive = s > 0 || s == 0 && t >= 0;
    boolean isOtherPositive = t > 0 || t == 0 && s >= 0;
    int corner = isPositive ? octahedron.center() : -octahedron.center();
    int otherCorner = isOtherPositive ? octahedron.center() : -octahedron.center();
    int other = 2 * t - otherCorner;
    return ((isPositive == isOtherPositive ? -other : other) + corner) / 2;
  }

  /** Returns how many quarter turns bring a point to the quarter of negative coordinates. */
  private static int turns(int s, int t) {
    if (s == 0) {
      return t == 0 ? 0 : t > 0 ? 3 : 1;
    }
    return s > 0 ? (t >= 0 ? 2 : 1) : t <= 0 ? 0 : 3;
  }

  /** Returns the first coordinate of a point after a number of quarter turns. */
  private static int turned(int s, int t, int turns) {
    return switch (turns) {
      case 1 -> t;
      case 2 -> -s;
      case 3 -> -t;
      default -> s;
    };
  }

  private int wrapped(int coordinate) {
    int size = 2 * octahedron.center() + 1;
    return coordinate > octahedron.center()
        ? coordinate - size
        : coordinate < -octahedron.center() ? coordinate + size : coordinate;
  }
}
