package io.github.lumbre.render.preview;

import java.util.function.LongSupplier;

/**
 * Decides when work beside a render is due, so that all of it but the first piece takes a small
 * share of the rendering time. Mutable. One thread does the work; any thread may call {@link
 * #isDue}.
 */
final class PreviewPace {
  /** The shortest time between two pieces of work. */
  static final long LEAST_NANOS = 200_000_000;

  /** The time before the first piece of work. */
  static final long FIRST_NANOS = 50_000_000;

  private final double share;
  private final long credit;
  private final LongSupplier clock;
  private final long start;
  private long spent;
  private boolean isFirst = true;
  private volatile long next;

  /**
   * @param share the share of the time since the start that the work may take
   * @param creditNanos the time that the work may take besides, so that it starts soon
   * @param clock in nanoseconds, such as {@link System#nanoTime}
   */
  PreviewPace(double share, long creditNanos, LongSupplier clock) {
    this.share = share;
    this.clock = clock;
    credit = creditNanos;
    start = clock.getAsLong();
    next = start + FIRST_NANOS;
  }

  boolean isDue() {
    return clock.getAsLong() - next >= 0;
  }

  /**
   * Sets when the next piece of work is due, which is expected to cost as much as this one.
   *
   * @param cost of this piece, in nanoseconds
   */
  void spend(long cost) {
    long now = clock.getAsLong();
    // The first piece also waits for the JIT, which says nothing about the next ones.
    spent += isFirst ? 0 : cost;
    long expected = isFirst ? 0 : cost;
    isFirst = false;
    double wait = (spent + expected - credit) / share - (now - start);
    next = now + Math.max(LEAST_NANOS, (long) wait);
  }
}
