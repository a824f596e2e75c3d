package io.github.lumbre.model.format.off;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Corners;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.TriangleList;
import io.github.lumbre.model.internal.Warnings;
import java.util.Arrays;

/** The vertices of an OFF text. Mutable. */
final class OffVertices {
  /** A position, a normal, a color with alpha, and texture coordinates. */
  private static final int MOST_NUMBERS = 12;

  private static final long MOST_BYTES = 24 + 24 + 16 + 16;
  private static final double[] NONE = {};

  private final OffHeader header;
  private final OffLayout layout;
  private final double[] positions;
  private final double[] uvs;
  private final OffColors colors;

  /** Empty if there are none. */
  private double[] normals;

  /**
   * @throws ModelFormatException if the vertices need more memory than the limits allow
   */
  OffVertices(OffHeader header, OffLayout layout, Limits limits) throws ModelFormatException {
    this.header = header;
    this.layout = layout;
    int count = header.vertices();
    ModelLimits.requireMemory("", MOST_BYTES * count, limits);
    positions = new double[3 * count];
    normals = header.hasNormals() ? new double[3 * count] : NONE;
    uvs = header.hasCoordinates() ? new double[2 * count] : NONE;
    colors = new OffColors(count);
  }

  void read(TextScanner scanner, Tally tally) throws ModelFormatException {
    double[] numbers = new double[MOST_NUMBERS];
    for (int i = 0; i < header.vertices(); i++) {
      if (!scanner.nextWordOfText()) {
        throw scanner.error("expected " + header.vertices() + " vertices, found " + i);
      }
      int line = scanner.line();
      int size = 0;
      do {
        numbers[size++] = scanner.numberOrNan();
      } while (hasNext(size, scanner));
      if (scanner.line() > line && !layout.isTokens() && scanner.hasMoreWords()) {
        throw scanner.error("expected the end of the line after a vertex, found more");
      }
      put(i, numbers, size, scanner, tally);
      layout.end(scanner);
    }
  }

  /**
   * Moves to the next number of a vertex; returns false if there is none.
   *
   * @param size how many numbers have been read
   */
  private boolean hasNext(int size, TextScanner scanner) {
    int least = 3 + (header.hasNormals() ? 3 : 0) + (header.hasCoordinates() ? 2 : 0);
    if (layout.isTokens()) {
      int count = least + (header.hasColors() ? layout.colorSize() : 0);
      return size < count && scanner.nextWordOfText();
    }
    return size < least ? layout.next(scanner) : size < MOST_NUMBERS && scanner.nextWord();
  }

  private void put(int vertex, double[] numbers, int size, TextScanner scanner, Tally tally)
      throws ModelFormatException {
    int color = 3 + (normals.length > 0 ? 3 : 0);
    int uv = size - (uvs.length > 0 ? 2 : 0);
    if (uv < color) {
      throw scanner.error("expected %d numbers, found %d".formatted(color + size - uv, size));
    }
    System.arraycopy(numbers, 0, positions, 3 * vertex, 3);
    if (normals.length > 0) {
      System.arraycopy(numbers, 3, normals, 3 * vertex, 3);
    }
    for (int i = uv; i < size && uvs.length > 0; i++) {
      uvs[2 * vertex + i - uv] = Double.isFinite(numbers[i]) ? numbers[i] : 0;
    }
    if (header.hasColors()) {
      colors.put(vertex, numbers, color, uv - color, scanner, tally);
    } else if (uv > color || !layout.isTokens() && scanner.hasMoreWords()) {
      tally.add("ignored words at the end of a line", scanner.location());
    }
  }

  /** Returns three coordinates per vertex; NaN for those that are not finite. */
  double[] positions() {
    return positions;
  }

  boolean hasColors() {
    return colors.isPresent();
  }

  /** Replaces positions that are not finite by 0, which no triangle uses, and drops normals. */
  void repair(Warnings warnings) {
    TriangleList.clearBroken(positions);
    if (Arrays.stream(normals).anyMatch(Double::isNaN)) {
      warnings.add("", "ignored the normals, because some are not finite");
      normals = NONE;
    }
  }

  /** Returns the geometry of triangles between the vertices. */
  ModelGeometry geometry(int... indices) {
    return new ModelGeometry(positions, normals, NONE, uvs, NONE, colors.linear(), indices);
  }

  /**
   * Returns the geometry of triangles with a color each.
   *
   * @param indices three vertices per triangle; changed
   * @param faces the number of the face of each triangle
   */
  ModelGeometry geometry(int[] indices, int[] faces, OffColors painted) {
    Corners corners = new Corners();
    for (int i = 0; i < indices.length; i++) {
      indices[i] = corners.number(indices[i], faces[i / 3], 0);
    }
    return new ModelGeometry(
        corners.gather(0, positions, 3),
        corners.gather(0, normals, 3),
        NONE,
        corners.gather(0, uvs, 2),
        NONE,
        corners.gather(1, painted.linear(), 4),
        indices);
  }
}
