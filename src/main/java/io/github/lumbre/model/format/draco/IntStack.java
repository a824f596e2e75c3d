package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/** A stack of integers, whose memory is counted. Mutable. */
final class IntStack {
  private static final int INITIAL = 64;

  private final DracoInput input;
  private int[] items;
  private int size;

  IntStack(DracoInput input) throws ModelFormatException {
    this.input = input;
    items = input.integers(INITIAL);
  }

  boolean isEmpty() {
    return size == 0;
  }

  void push(int item) throws ModelFormatException {
    if (size == items.length) {
      int[] more = input.integers(2L * size);
      System.arraycopy(items, 0, more, 0, size);
      items = more;
    }
    items[size++] = item;
  }

  /** Removes the last item, which must exist, and returns it. */
  int pop() {
    return items[--size];
  }
}
