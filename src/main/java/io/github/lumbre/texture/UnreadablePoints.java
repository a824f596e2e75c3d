package io.github.lumbre.texture;

import java.util.concurrent.atomic.LongAdder;

/**
 * Counts the points at which textures were read and that are not finite, as of coordinates near the
 * largest number times a scale. They are read at (0, 0), which is wrong but harmless; whoever
 * renders may tell of it. Safe for use by any thread.
 */
public final class UnreadablePoints {
  private static final LongAdder COUNT = new LongAdder();

  private UnreadablePoints() {}

  static void count() {
    COUNT.increment();
  }

  /** Returns how many there were since the program's start, in all renders together. */
  public static long total() {
    return COUNT.sum();
  }
}
