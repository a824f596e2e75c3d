package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/**
 * Corrections that are added, and wrap around at the ends of the range of the values.
 *
 * @param components numbers per value
 * @param min the lowest number
 * @param max the highest number
 */
record WrappedCorrection(int components, int min, int max) implements Correction {
  static WrappedCorrection read(DracoInput input, int components) throws ModelFormatException {
    int min = input.integer();
    int max = input.integer();
    if ((long) max - min < 0 || (long) max - min >= Integer.MAX_VALUE) {
      throw input.malformed("expected a range of numbers, found " + min + " to " + max);
    }
    return new WrappedCorrection(components, min, max);
  }

  @Override
  public void apply(int[] predicted, int from, int[] values, int at) {
    int size = 1 + max - min;
    for (int c = 0; c < components; c++) {
      int value = Math.max(min, Math.min(max, predicted[from + c])) + values[at + c];
      values[at + c] = value > max ? value - size : value < min ? value + size : value;
    }
  }
}
