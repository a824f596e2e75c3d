package io.github.lumbre.image.format.ktx;

import io.github.lumbre.image.ImageFormatException;

/**
 * The two lists to which blocks refer (BasisLZ/ETC1S Bitstream Specification). Immutable.
 *
 * @param colors four for each entry, with red in the lowest byte
 * @param selectors for each entry, 2 bits for each texel, the first in the lowest bits: which of
 *     the four colors the texel has
 */
record Etc1sCodeBooks(int[] colors, int[] selectors) {
  /** The number of colors of a block. */
  static final int COLORS = 4;

  private static final int START = 16;
  private static final int MASK = 31;
  private static final int[][] MODIFIERS = {
    {-8, -2, 2, 8},
    {-17, -5, 5, 17},
    {-29, -9, 9, 29},
    {-42, -13, 13, 42},
    {-60, -18, 18, 60},
    {-80, -24, 24, 80},
    {-106, -33, 33, 106},
    {-183, -47, 47, 183}
  };

  static Etc1sCodeBooks read(
      BasisBits endpoints, int endpointCount, BasisBits selectors, int selectorCount)
      throws ImageFormatException {
    return new Etc1sCodeBooks(
        readColors(endpoints, endpointCount), readSelectors(selectors, selectorCount));
  }

  private static int[] readColors(BasisBits in, int count) throws ImageFormatException {
    BasisCode[] codes = {BasisCode.read(in), BasisCode.read(in), BasisCode.read(in)};
    BasisCode modifierCode = BasisCode.read(in);
    boolean isGray = in.read(1) != 0;
    int[] colors = new int[COLORS * count];
    int[] base = {START, START, START};
    int modifier = 0;
    for (int i = 0; i < count; i++) {
      modifier = modifier + modifierCode.decode(in) & MODIFIERS.length - 1;
      for (int channel = 0; channel < base.length; channel++) {
        int last = base[channel];
        base[channel] =
            isGray && channel > 0
                ? base[0]
                : last + codes[last < 10 ? 0 : last < 22 ? 1 : 2].decode(in) & MASK;
      }
      for (int k = 0; k < COLORS; k++) {
        colors[COLORS * i + k] = color(base, MODIFIERS[modifier][k]);
      }
    }
    return colors;
  }

  private static int color(int[] base, int modifier) {
    int color = 0;
    for (int channel = 0; channel < base.length; channel++) {
      int value = (base[channel] << 3 | base[channel] >> 2) + modifier;
      color |= Math.max(0, Math.min(0xff, value)) << Byte.SIZE * channel;
    }
    return color;
  }

  private static int[] readSelectors(BasisBits in, int count) throws ImageFormatException {
    if (in.read(2) != 0) {
      throw in.damaged("begins with bits other than 0");
    }
    int[] selectors = new int[count];
    if (in.read(1) != 0) {
      for (int i = 0; i < count; i++) {
        selectors[i] = in.read(Integer.SIZE);
      }
      return selectors;
    }
    BasisCode code = BasisCode.read(in);
    int last = 0;
    for (int i = 0; i < count; i++) {
      last ^=
          i == 0
              ? in.read(Integer.SIZE)
              : row(code, in, 0) | row(code, in, 1) | row(code, in, 2) | row(code, in, 3);
      selectors[i] = last;
    }
    return selectors;
  }

  private static int row(BasisCode code, BasisBits in, int row) throws ImageFormatException {
    return (code.decode(in) & 0xff) << Byte.SIZE * row;
  }
}
