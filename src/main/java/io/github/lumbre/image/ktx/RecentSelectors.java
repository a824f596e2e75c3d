package io.github.lumbre.image.ktx;

/**
 * Indices of selectors that were used lately, roughly the latest first (BasisLZ/ETC1S Bitstream
 * Specification, approximate move to front). Mutable.
 */
final class RecentSelectors {
  private final int[] values;
  private int next;

  RecentSelectors(int size) {
    values = new int[size];
    next = size / 2;
  }

  int size() {
    return values.length;
  }

  void add(int selector) {
    values[next] = selector;
    next = next + 1 == values.length ? values.length / 2 : next + 1;
  }

  /** Returns a selector, and moves it forward. */
  int use(int index) {
    int selector = values[index];
    values[index] = values[index / 2];
    values[index / 2] = selector;
    return selector;
  }
}
