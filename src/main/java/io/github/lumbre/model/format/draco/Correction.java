package io.github.lumbre.model.format.draco;

/** How a correction changes a predicted value (Draco specification, Prediction Transform). */
interface Correction {
  /**
   * Replaces a correction by a value.
   *
   * @param predicted has the prediction
   * @param from the index of its first number, which may change
   * @param values has the correction
   * @param at the index of its first number
   */
  void apply(int[] predicted, int from, int[] values, int at);
}
