package io.github.lumbre.geometry.internal;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.DoubleAdder;

/**
 * What this JVM has compiled, and how long its renders have computed without it. Static, because
 * all renders share one JIT: what one has compiled serves all, and many short renders together make
 * compiling pay. It changes their speed and no bit of their pictures. Mutable and thread-safe.
 */
public final class CompiledKernel {
  /** The longest time between two passes of a render that continues. */
  private static final long PAUSE_NANOS = 2_000_000_000;

  /** Seconds of the threads of passes with plain Java, less what a change has used up. */
  private static final DoubleAdder SPENT = new DoubleAdder();

  /** The number of passes that are running. */
  private static final AtomicInteger RUNNING = new AtomicInteger();

  private static volatile long lastEnd;
  private static volatile boolean isCompiled;
  private static volatile boolean hasDenoised;

  private CompiledKernel() {}

  /** Returns whether the vector kernel is known to be compiled in this JVM. */
  public static boolean isCompiled() {
    return isCompiled;
  }

  /** Sets whether the vector kernel is known to be compiled; tests forget it. */
  public static void setCompiled(boolean compiled) {
    isCompiled = compiled;
  }

  /** Returns whether a picture was denoised in this JVM, so that this code is compiled. */
  public static boolean hasDenoised() {
    return hasDenoised;
  }

  /** Takes note of a denoised picture. */
  public static void denoised() {
    hasDenoised = true;
  }

  /** Adds seconds of the threads of a pass, or takes away used ones; returns what is left. */
  public static double spent(double seconds) {
    SPENT.add(seconds);
    return SPENT.sum();
  }

  /** Takes note of the begin of a pass. */
  public static void begin() {
    RUNNING.incrementAndGet();
  }

  /** Takes note of the end of a pass. */
  public static void end() {
    lastEnd = System.nanoTime();
    RUNNING.decrementAndGet();
  }

  /** Returns whether a pass is running, or may follow on one that has just ended. */
  public static boolean isRendering() {
    return RUNNING.get() > 0 || System.nanoTime() - lastEnd < PAUSE_NANOS;
  }
}
