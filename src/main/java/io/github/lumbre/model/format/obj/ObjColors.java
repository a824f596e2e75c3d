package io.github.lumbre.model.format.obj;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Corners;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.Warnings;
import java.util.Arrays;

/**
 * The colors that several tools write after the positions of an OBJ text: three sRGB-encoded
 * components in [0,1], or in [0,255] if one is larger than 1. Mutable.
 */
final class ObjColors {
  private static final double NONE = -1;

  /** Larger components are not 1, rounded. */
  private static final double MAX_FRACTION = 1.001;

  private static final double MAX_BYTE = 255;

  private final int length;

  /** Three components per vertex as in the file, or NONE; empty until a vertex has a color. */
  private double[] rgb = {};

  private double largest = 1;

  /** The place of the largest component. */
  private String location = "";

  /**
   * @param vertices the number of positions
   */
  ObjColors(int vertices) {
    length = Math.multiplyExact(3, vertices);
  }

  /**
   * Reads the numbers after a position. A single number there is a weight, which has no effect on
   * polygons.
   */
  void read(TextScanner scanner, int vertex, Tally tally) throws ModelFormatException {
    double[] read = new double[3];
    int count = 0;
    while (count < 3 && scanner.nextWord()) {
      read[count++] = Math.max(0, scanner.numberOrNan());
    }
    if (count < 3) {
      return;
    }
    if (Double.isNaN(read[0] + read[1] + read[2])) {
      tally.add("ignored colors of vertices that are not finite", scanner.location());
      return;
    }
    if (rgb.length == 0) {
      rgb = new double[length];
      Arrays.fill(rgb, NONE);
    }
    System.arraycopy(read, 0, rgb, 3 * vertex, 3);
    double max = Math.max(read[0], Math.max(read[1], read[2]));
    if (max > largest) {
      largest = max;
      location = scanner.location();
    }
  }

  /** Makes the components linear, after the last vertex. */
  void finish(Warnings warnings) {
    boolean isBytes = largest > MAX_FRACTION;
    if (largest > MAX_BYTE) {
      warnings.add(
          location,
          "ignored the colors of vertices: expected 0 to 1 or 0 to 255, found "
              + PrintableText.number(largest));
      rgb = new double[0];
    } else if (isBytes) {
      warnings.add(
          location,
          "took the colors of vertices for 0 to 255: expected 0 to 1, found "
              + PrintableText.number(largest));
    }
    for (int i = 0; i < rgb.length; i++) {
      if (rgb[i] != NONE) {
        rgb[i] = Srgb.decode(isBytes ? rgb[i] / MAX_BYTE : Math.min(rgb[i], 1));
      }
    }
  }

  /**
   * Returns four linear components per corner, after {@link #finish}; empty if none has a color.
   *
   * @param otherwise gray of corners without a color
   */
  float[] of(Corners corners, double otherwise) {
    if (rgb.length == 0) {
      return new float[0];
    }
    double[] gathered = corners.gather(0, rgb, 3);
    if (Arrays.stream(gathered).allMatch(c -> c == NONE)) {
      return new float[0];
    }
    float[] rgba = new float[Math.multiplyExact(4, gathered.length / 3)];
    for (int i = 0; i < rgba.length; i++) {
      double component = i % 4 == 3 ? 1 : gathered[3 * (i / 4) + i % 4];
      rgba[i] = (float) (component == NONE ? otherwise : component);
    }
    return rgba;
  }
}
