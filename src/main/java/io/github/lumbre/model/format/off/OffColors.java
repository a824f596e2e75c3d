package io.github.lumbre.model.format.off;

import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TextScanner;
import java.util.Arrays;

/**
 * The colors of the vertices or of the faces of an OFF text: sRGB-encoded components in [0,1], or
 * in [0,255] if one is larger than 1. Tools write both with and without decimal points, so that
 * only the largest component decides. Mutable.
 */
final class OffColors {
  private static final float NONE = -1;

  /** Larger components are not 1, rounded. */
  private static final double MAX_FRACTION = 1.001;

  private static final double MAX_BYTE = 255;

  private final int count;

  /** Four components per item as in the file, or NONE; empty until an item has a color. */
  private float[] rgba = {};

  private boolean isBytes;

  /**
   * @param count the number of items, below 2^29
   */
  OffColors(int count) {
    this.count = count;
  }

  /**
   * Sets the color of an item.
   *
   * @param numbers of the item in the file
   * @param from index of red, which green, blue and perhaps alpha follow
   * @param size of the color: 3 or 4; colors of other sizes are ignored
   * @param scanner names the place
   * @param tally receives colors that are ignored
   */
  void put(int item, double[] numbers, int from, int size, TextScanner scanner, Tally tally) {
    double sum = 0;
    for (int i = from; i < from + size; i++) {
      sum += numbers[i];
    }
    if (size < 3 || size > 4 || Double.isNaN(sum)) {
      String ignored =
          size == 1 ? "indices of a table of colors" : "colors of other than 3 or 4 numbers";
      tally.add("ignored " + ignored, scanner.location());
      return;
    }
    if (rgba.length == 0) {
      rgba = new float[4 * count];
      Arrays.fill(rgba, NONE);
    }
    rgba[4 * item + 3] = Float.MAX_VALUE;
    for (int i = 0; i < size; i++) {
      rgba[4 * item + i] = (float) Math.max(0, numbers[from + i]);
      isBytes |= numbers[from + i] > MAX_FRACTION;
    }
  }

  boolean isPresent() {
    return rgba.length > 0;
  }

  /** Returns four linear components per item, light gray if it has none; empty if none has one. */
  float[] linear() {
    double scale = isBytes ? 1 / MAX_BYTE : 1;
    float[] linear = new float[rgba.length];
    for (int i = 0; i < rgba.length; i++) {
      boolean isAlpha = i % 4 == 3;
      double value = Math.min(scale * rgba[i], 1);
      linear[i] = (float) (isAlpha ? value : Srgb.decode(value));
      if (rgba[i] == NONE) {
        linear[i] = isAlpha ? 1 : (float) PlainModel.ALBEDO;
      }
    }
    return linear;
  }
}
