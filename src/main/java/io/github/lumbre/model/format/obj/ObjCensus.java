package io.github.lumbre.model.format.obj;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.TextScanner;

/**
 * The number of positions, texture coordinates, normals and triangles in an OBJ text.
 *
 * @param hasSmoothing whether the text has smoothing groups
 */
record ObjCensus(int positions, int uvs, int normals, long triangles, boolean hasSmoothing) {
  /** Three doubles per vector. A triangle has three indices of half that size. */
  private static final long BYTES_PER_VECTOR = 3L * Double.BYTES;

  /** A corner, its slots in the table of corners, and its position. */
  private static final long BYTES_PER_POINT = 12 + 8 * Integer.BYTES + BYTES_PER_VECTOR;

  /**
   * @throws ModelFormatException if the mesh does not fit into memory, or exceeds the limits
   */
  static ObjCensus of(byte[] text, Limits limits) throws ModelFormatException {
    TextScanner scanner = new TextScanner(text);
    int positions = 0;
    int uvs = 0;
    int normals = 0;
    long triangles = 0;
    long points = 0;
    boolean hasSmoothing = false;
    while (scanner.hasMore()) {
      if (scanner.nextWord()) {
        if (scanner.wordIs("v")) {
          positions++;
        } else if (scanner.wordIs("vt")) {
          uvs++;
        } else if (scanner.wordIs("vn")) {
          normals++;
        } else if (scanner.wordIs("f")) {
          triangles += Math.max(0, words(scanner) - 2);
        } else if (scanner.wordIs("p")) {
          points += words(scanner);
        } else if (scanner.wordIs("s")) {
          hasSmoothing |= scanner.nextWord() && !scanner.wordIs("off") && !scanner.wordIs("0");
        }
      }
      scanner.endLine();
    }
    ObjCensus census = new ObjCensus(positions, uvs, normals, triangles, hasSmoothing);
    census.requireRoom(triangles + points == 0 ? positions : points, limits);
    return census;
  }

  /**
   * @param points the number of points; all vertices without triangles and points
   */
  private void requireRoom(long points, Limits limits) throws ModelFormatException {
    long most = Math.max(Math.max(positions, uvs), Math.max(normals, triangles));
    ModelLimits.require("", "vertices and triangles", ModelLimits.MAX_COUNT, most);
    ModelLimits.require("", "points", ModelLimits.MAX_COUNT, points);
    long bytes = BYTES_PER_VECTOR * ((long) positions + uvs + normals) + 12 * triangles;
    bytes += BYTES_PER_POINT * points;
    ModelLimits.requireMemory("", bytes, limits);
    ModelLimits.requireTriangles("", triangles, limits);
    ModelLimits.requireHeap("", triangles);
    ModelLimits.require("", "points", limits.triangles(), points);
  }

  private static int words(TextScanner scanner) {
    int count = 0;
    while (scanner.nextWord()) {
      count++;
    }
    return count;
  }
}
