package io.github.lumbre.testing;

import java.util.Collection;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;

/**
 * Runs independent parts of a test on all processors. Each part needs random numbers of its own.
 */
public final class InParallel {
  private InParallel() {}

  /** A test of one of several things. */
  public interface Part<T> {
    void test(T thing) throws Exception;
  }

  /** A measurement with the number of a part. */
  public interface Measurement<T> {
    T of(int number) throws Exception;
  }

  /** Tests all things; a failure of one is a failure of all. */
  public static <T> void forEach(Collection<T> things, Part<T> part) {
    things.parallelStream()
        .forEach(
            thing ->
                unchecked(
                    () -> {
                      part.test(thing);
                      return null;
                    }));
  }

  /** Returns what is measured with the numbers from 0, in their order. */
  public static <T> List<T> measured(int count, Measurement<T> measurement) {
    return IntStream.range(0, count)
        .parallel()
        .mapToObj(number -> unchecked(() -> measurement.of(number)))
        .toList();
  }

  private static <T> T unchecked(Callable<T> work) {
    try {
      return work.call();
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }
}
