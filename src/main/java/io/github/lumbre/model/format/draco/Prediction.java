package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/** Predicts the values of an attribute from those before them. */
interface Prediction {
  /**
   * Replaces corrections by values, in the order of the entries.
   *
   * @param values numbers of all entries
   */
  void restore(int[] values) throws ModelFormatException;
}
