package io.github.lumbre.integrator.guiding;

/**
 * A range of an order: the records of one place.
 *
 * @param from first place of the order
 * @param to place after the last
 */
record RecordRange(RecordOrder order, int from, int to) {
  int size() {
    return to - from;
  }

  int record(int place) {
    return order.record(from + place);
  }
}
