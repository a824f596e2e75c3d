package io.github.lumbre;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * How functions are timed: nanoseconds a call, on one thread, in two virtual machines.
 *
 * <p>Each benchmark calls its function for {@link #COUNT} inputs that were drawn before, from fixed
 * seeds, so that neither drawing them nor reading the clock counts.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@State(Scope.Thread)
@Fork(2)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public abstract class MicroBenchmark {
  /**
   * How many inputs there are: enough to keep the processor from learning its branches by heart.
   */
  protected static final int COUNT = 4096;
}
