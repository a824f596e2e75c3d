package io.github.lumbre.cli.view;

import io.github.lumbre.render.Progress;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;

/** Samples and time of a render that may be stopped and continued. Thread-safe. */
final class RenderClock implements Progress {
  private final AtomicLong samples = new AtomicLong();
  private final BooleanSupplier isCancelled;
  private volatile long activeNanos;
  private volatile long startNanos;
  private volatile boolean isRunning;
  private volatile long goal = Long.MAX_VALUE;
  private volatile double limit = Double.POSITIVE_INFINITY;

  RenderClock(BooleanSupplier isCancelled) {
    this.isCancelled = isCancelled;
  }

  void start() {
    startNanos = System.nanoTime();
    isRunning = true;
  }

  void stop() {
    if (isRunning) {
      isRunning = false;
      activeNanos += System.nanoTime() - startNanos;
    }
  }

  @Override
  public void advanced(long more) {
    samples.addAndGet(more);
  }

  @Override
  public boolean isCancelled() {
    return isCancelled.getAsBoolean();
  }

  /** Corrects the number of samples: a pass that is paused does not report its last ones. */
  void correct(long allSamples) {
    samples.set(allSamples);
  }

  /** Sets the expected number of samples at the end, over all pixels. */
  void expect(long allSamples) {
    goal = allSamples;
  }

  /** Sets the seconds of rendering at the end. */
  void limit(double seconds) {
    limit = seconds;
  }

  long samples() {
    return samples.get();
  }

  /** Returns the seconds of rendering, without those while it was stopped. */
  double seconds() {
    return 1e-9 * (activeNanos + (isRunning ? System.nanoTime() - startNanos : 0));
  }

  /** Returns the samples per second. */
  double rate() {
    double seconds = seconds();
    return seconds > 0 ? samples.get() / seconds : 0;
  }

  /** Returns the expected seconds of rendering until the end; empty if unknown. */
  OptionalDouble secondsLeft() {
    double rate = rate();
    double bySamples =
        goal < Long.MAX_VALUE && rate > 0
            ? Math.max(0, goal - samples.get()) / rate
            : Double.POSITIVE_INFINITY;
    double left = Math.min(bySamples, Math.max(0, limit - seconds()));
    return left < Double.POSITIVE_INFINITY ? OptionalDouble.of(left) : OptionalDouble.empty();
  }
}
