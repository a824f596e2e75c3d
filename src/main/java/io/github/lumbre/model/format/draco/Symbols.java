package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/** The symbols of an edgebreaker traversal, which say how each face meets those before it. */
@FunctionalInterface
interface Symbols {
  /** A face between two open edges, which closes a vertex. */
  int CENTER = 0;

  /** A face that joins two open boundaries. */
  int SPLIT = 1;

  /** A face with a new vertex; the next face is to its left. */
  int LEFT = 2;

  /** A face with a new vertex; the next face is to its right. */
  int RIGHT = 3;

  /** A face with three new vertices. */
  int END = 4;

  /** Reads the bytes of all symbols, which have one or three bits. */
  static Symbols standard(DracoInput input, int count) throws ModelFormatException {
    int size = input.count("bytes of symbols", input.remaining());
    if (count > (long) Byte.SIZE * size) {
      throw input.malformed("expected " + count + " symbols, found " + size + " bytes of them");
    }
    int from = input.skip(size);
    BitReader bits = new BitReader(input.bytes(), from, from + size);
    return () -> bits.read(1) == 0 ? CENTER : SPLIT + bits.read(2);
  }

  int next() throws ModelFormatException;

  /**
   * Notes that the face of the last symbol is complete.
   *
   * @param corner its first
   */
  default void added(int corner, OpenMesh mesh) {}

  /** Notes that a vertex becomes a part of another. */
  default void merged(int from, int to) {}
}
