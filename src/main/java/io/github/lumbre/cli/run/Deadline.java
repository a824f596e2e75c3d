package io.github.lumbre.cli.run;

import io.github.lumbre.base.limit.Limits;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;

/** A deadline, measured by {@link System#nanoTime} or another clock. Immutable. */
public final class Deadline {
  static final Deadline NEVER = new Deadline(Optional.empty(), System::nanoTime);

  private final Optional<Duration> time;
  private final LongSupplier clock;
  private final long start;

  private Deadline(Optional<Duration> time, LongSupplier clock) {
    this.time = time;
    this.clock = clock;
    start = clock.getAsLong();
  }

  /** Returns the deadline after a time from now, or {@link #NEVER} if no time is given. */
  public static Deadline after(Optional<Duration> time) {
    return after(time, System::nanoTime);
  }

  /**
   * Returns the deadline after a time from now, measured by a clock.
   *
   * @param clock thread-safe clock in nanoseconds
   */
  static Deadline after(Optional<Duration> time, LongSupplier clock) {
    return time.isEmpty() ? NEVER : new Deadline(time, clock);
  }

  boolean hasPassed() {
    return secondsLeft().orElse(1) <= 0;
  }

  /** Returns the time until the deadline, negative after it; no limit if it never passes. */
  Duration left() {
    return time.map(t -> t.minusNanos(clock.getAsLong() - start)).orElse(Limits.NO_TIME_LIMIT);
  }

  /** Returns the seconds until the deadline, negative after it; empty if it never passes. */
  OptionalDouble secondsLeft() {
    return time.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(1e-9 * left().toNanos());
  }
}
