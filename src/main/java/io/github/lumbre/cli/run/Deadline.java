package io.github.lumbre.cli.run;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;

/** A moment of a clock, by default the machine's own, after which work is to end. Immutable. */
public final class Deadline {
  /** Never comes. */
  static final Deadline NEVER = new Deadline(Optional.empty(), System::nanoTime);

  private final Optional<Duration> time;
  private final LongSupplier clock;
  private final long start;

  private Deadline(Optional<Duration> time, LongSupplier clock) {
    this.time = time;
    this.clock = clock;
    start = clock.getAsLong();
  }

  /** Returns the moment that is so long from now; never, if there is no such time. */
  public static Deadline after(Optional<Duration> time) {
    return after(time, System::nanoTime);
  }

  /**
   * Returns the moment that is so long from now by a clock.
   *
   * @param clock in nanoseconds; safe for use by any thread
   */
  static Deadline after(Optional<Duration> time, LongSupplier clock) {
    return time.isEmpty() ? NEVER : new Deadline(time, clock);
  }

  /** Tells whether the moment has come. */
  boolean hasPassed() {
    return time.isPresent() && clock.getAsLong() - start >= time.get().toNanos();
  }

  /** Returns the seconds until the moment, negative after it; empty if it never comes. */
  OptionalDouble secondsLeft() {
    return time.isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(1e-9 * (start + time.get().toNanos() - clock.getAsLong()));
  }
}
