package io.github.lumbre.model.obj;

import io.github.lumbre.limit.Limits;
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

  /**
   * @throws ModelFormatException if the mesh does not fit into memory, or exceeds the limits
   */
  static ObjCensus of(byte[] text, Limits limits) throws ModelFormatException {
    TextScanner scanner = new TextScanner(text);
    int positions = 0;
    int uvs = 0;
    int normals = 0;
    long triangles = 0;
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
        } else if (scanner.wordIs("s")) {
          hasSmoothing |= scanner.nextWord() && !scanner.wordIs("off") && !scanner.wordIs("0");
        }
      }
      scanner.endLine();
    }
    ObjCensus census = new ObjCensus(positions, uvs, normals, triangles, hasSmoothing);
    census.requireRoom(limits);
    return census;
  }

  private void requireRoom(Limits limits) throws ModelFormatException {
    long most = Math.max(Math.max(positions, uvs), Math.max(normals, triangles));
    ModelLimits.require("", "vertices and triangles", ModelLimits.MAX_COUNT, most);
    long bytes = BYTES_PER_VECTOR * ((long) positions + uvs + normals) + 12 * triangles;
    ModelLimits.requireMemory("", bytes, limits);
    ModelLimits.requireTriangles("", triangles, limits);
  }

  private static int words(TextScanner scanner) {
    int count = 0;
    while (scanner.nextWord()) {
      count++;
    }
    return count;
  }
}
