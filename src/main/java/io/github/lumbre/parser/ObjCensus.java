package io.github.lumbre.parser;

/** How many of everything an OBJ text has. */
record ObjCensus(int positions, int uvs, int normals, long triangles) {
  /** What fits in an array of three numbers each. */
  private static final long MAX_COUNT = (Integer.MAX_VALUE - 8) / 3;

  /** A vector is three numbers, and so are a triangle's indices, of half the size. */
  private static final long BYTES_PER_VECTOR = 3L * Double.BYTES;

  /**
   * @throws ObjFormatException if there is more than fits into memory
   */
  static ObjCensus of(byte[] text) throws ObjFormatException {
    return of(text, Runtime.getRuntime().maxMemory());
  }

  static ObjCensus of(byte[] text, long maxHeapBytes) throws ObjFormatException {
    ObjScanner scanner = new ObjScanner(text);
    int positions = 0;
    int uvs = 0;
    int normals = 0;
    long triangles = 0;
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
        }
      }
      scanner.endLine();
    }
    ObjCensus census = new ObjCensus(positions, uvs, normals, triangles);
    census.requireRoom(scanner, maxHeapBytes);
    return census;
  }

  private void requireRoom(ObjScanner scanner, long maxHeapBytes) throws ObjFormatException {
    long most = Math.max(Math.max(positions, uvs), Math.max(normals, triangles));
    if (most > MAX_COUNT) {
      throw scanner.tooLarge(
          "expected at most " + MAX_COUNT + " vertices and triangles, found " + most);
    }
    long bytes = BYTES_PER_VECTOR * ((long) positions + uvs + normals) + 12 * triangles;
    if (bytes > maxHeapBytes) {
      throw scanner.tooLarge(
          "expected a mesh that takes at most "
              + maxHeapBytes
              + " bytes of memory, found one that takes "
              + bytes);
    }
  }

  private static int words(ObjScanner scanner) {
    int count = 0;
    while (scanner.nextWord()) {
      count++;
    }
    return count;
  }
}
