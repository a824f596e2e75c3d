package io.github.lumbre.model.format.draco;

/**
 * Decoded positions, as integers, from which other attributes are predicted.
 *
 * @param entries three numbers each
 * @param ofPoints the entries of all points
 * @param points of all corners
 */
record Positions(int[] entries, int[] ofPoints, int[] points) {
  /** Returns the index of the first number of the position of a corner. */
  int index(int corner) {
    return 3 * ofPoints[points[corner]];
  }
}
