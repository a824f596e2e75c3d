package io.github.lumbre.model.draco;

import io.github.lumbre.model.ModelFormatException;

/** The symbols of an edgebreaker traversal, which say how each face meets those before it. */
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
