package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.NONE;
import static io.github.lumbre.model.format.draco.CornerTable.next;
import static io.github.lumbre.model.format.draco.CornerTable.previous;

/**
 * Predicts the fourth corner of a parallelogram; the face across an edge is its other half.
 *
 * @param entries their order
 * @param table the connectivity of the entries
 * @param components numbers per value
 * @param correction of a prediction
 */
record Parallelogram(Entries entries, CornerTable table, int components, Correction correction)
    implements Prediction {
  @Override
  public void restore(int[] values) {
    int[] predicted = new int[components];
    if (values.length > 0) {
      correction.apply(predicted, 0, values, 0);
    }
    for (int entry = 1; entry < entries.count(); entry++) {
      int at = entry * components;
      if (predict(entry, entries.corner(entry), values, predicted, 0)) {
        correction.apply(predicted, 0, values, at);
      } else {
        correction.apply(values, at - components, values, at);
      }
    }
  }

  /**
   * Predicts the value of an entry from the face across an edge.
   *
   * @param corner of the entry, opposite to the edge
   * @param target receives the prediction, from an index on
   * @return whether there is a face whose three entries come before
   */
  boolean predict(int entry, int corner, int[] values, int[] target, int to) {
    int opposite = table.opposites()[corner];
    if (opposite == NONE) {
      return false;
    }
    int[] vertices = table.vertices();
    int far = entries.of(vertices[opposite]);
    int a = entries.of(vertices[next(opposite)]);
    int b = entries.of(vertices[previous(opposite)]);
    if (far >= entry || a >= entry || b >= entry) {
      return false;
    }
    for (int c = 0; c < components; c++) {
      target[to + c] =
          values[a * components + c] + values[b * components + c] - values[far * components + c];
    }
    return true;
  }
}
