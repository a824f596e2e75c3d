package io.github.lumbre.model.meshopt;

import io.github.lumbre.model.ModelFormatException;

/** The last 16 values of a kind. Mutable. */
final class RecentIndices {
  private static final int CAPACITY = 16;

  private final long[] values = new long[CAPACITY];
  private int added;

  void add(long value) {
    values[added++ % CAPACITY] = value;
  }

  /**
   * Returns a value.
   *
   * @param age in [0, 16): 0 is the last value
   * @param input for messages
   */
  long get(int age, MeshoptInput input) throws ModelFormatException {
    if (age >= added) {
      throw input.malformed("expected one of " + added + " recent values, found " + age);
    }
    return values[(added - 1 - age) % CAPACITY];
  }
}
