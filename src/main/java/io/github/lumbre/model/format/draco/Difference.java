package io.github.lumbre.model.format.draco;

/**
 * Predicts the value before.
 *
 * @param correction of a prediction
 * @param components numbers per value
 */
record Difference(Correction correction, int components) implements Prediction {
  @Override
  public void restore(int[] values) {
    if (values.length > 0) {
      correction.apply(new int[components], 0, values, 0);
    }
    for (int at = components; at < values.length; at += components) {
      correction.apply(values, at - components, values, at);
    }
  }
}
