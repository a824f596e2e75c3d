package io.github.lumbre.parser;

/** How many of everything an OBJ text has. */
record ObjCensus(int positions, int uvs, int normals, long triangles) {
  /** What fits in an array of three indices each. */
  private static final long MAX_TRIANGLES = (Integer.MAX_VALUE - 8) / 3;

  /**
   * @throws ObjFormatException if there are more triangles than fit in memory
   */
  static ObjCensus of(byte[] text) throws ObjFormatException {
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
    if (triangles > MAX_TRIANGLES) {
      throw scanner.error("expected at most " + MAX_TRIANGLES + " triangles, found " + triangles);
    }
    return new ObjCensus(positions, uvs, normals, triangles);
  }

  private static int words(ObjScanner scanner) {
    int count = 0;
    while (scanner.nextWord()) {
      count++;
    }
    return count;
  }
}
