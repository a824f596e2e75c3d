package io.github.lumbre.cli.run;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;

/** A moment of the machine's own clock, after which work is to end. Immutable. */
public final class Deadline {
  /** Never comes. */
  static final Deadline NEVER = new Deadline(Optional.empty(), 0);

  private final Optional<Duration> time;
  private final long start;

  private Deadline(Optional<Duration> time, long start) {
    this.time = time;
    this.start = start;
  }

  /** Returns the moment that is so long from now; never, if there is no such time. */
  public static Deadline after(Optional<Duration> time) {
    return time.isEmpty() ? NEVER : new Deadline(time, System.nanoTime());
  }

  /** Tells whether the moment has come. */
  boolean hasPassed() {
    return time.isPresent() && System.nanoTime() - start >= time.get().toNanos();
  }

  /** Returns the seconds until the moment, negative after it; empty if it never comes. */
  OptionalDouble secondsLeft() {
    return time.isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(1e-9 * (start + time.get().toNanos() - System.nanoTime()));
  }
}
