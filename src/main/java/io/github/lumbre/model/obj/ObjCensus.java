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
  private static final long MAX_COUNT = ModelLimits.MAX_COUNT;

  /** Three doubles per vector. A triangle has three indices of half that size. */
  private static final long BYTES_PER_VECTOR = 3L * Double.BYTES;

  /**
   * @throws ModelFormatException if the mesh does not fit into memory, or exceeds the limits
   */
  static ObjCensus of(byte[] text, Limits limits) throws ModelFormatException {
    ObjCensus census = of(text, limits.heap());
    ModelLimits.requireTriangles("", census.triangles, limits);
    return census;
  }

  static ObjCensus of(byte[] text, long maxHeapBytes) throws ModelFormatException {
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
    census.requireRoom(scanner, maxHeapBytes);
    return census;
  }

  private void requireRoom(TextScanner scanner, long maxHeapBytes) throws ModelFormatException {
    long most = Math.max(Math.max(positions, uvs), Math.max(normals, triangles));
    if (most > MAX_COUNT) {
      throw scanner.tooLarge(
          "expected at most " + MAX_COUNT + " vertices and triangles, found " + most);
    }
    long bytes = BYTES_PER_VECTOR * ((long) positions + uvs + normals) + 12 * triangles;
    if (bytes > maxHeapBytes) {
      throw scanner.tooLarge(
          "expected a mesh that needs at most "
              + maxHeapBytes
              + " bytes of memory, found one that needs "
              + bytes);
    }
  }

  private static int words(TextScanner scanner) {
    int count = 0;
    while (scanner.nextWord()) {
      count++;
    }
    return count;
  }
}
