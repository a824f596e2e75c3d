package io.github.lumbre.cli.output;

import java.util.OptionalDouble;
import java.util.function.Supplier;

/** Shows the progress of a render. Thread-safe. */
public interface ProgressDisplay extends AutoCloseable {
  /** Shows nothing. */
  ProgressDisplay NONE =
      new ProgressDisplay() {
        @Override
        public void started(long totalSamples) {}

        @Override
        public void expected(long furtherSamples) {}

        @Override
        public void advanced(long samples) {}

        @Override
        public void close() {}
      };

  /**
   * Called when something starts that takes a while and is no render; it lasts until {@link
   * #started} or the next one.
   *
   * @param activity such as {@code reading chair.glb}
   */
  default void busy(String activity) {}

  /**
   * Called when a render starts, before its first sample.
   *
   * @param totalSamples number of samples; 0 if it is not known
   */
  void started(long totalSamples);

  /**
   * Called before the first sample.
   *
   * @param pixels number of pixels
   * @param before samples of all pixels that the picture has already
   * @param firstPass samples that are rendered whatever the time limit is
   */
  default void film(long pixels, long before, long firstPass) {}

  /** Called with an estimate of the remaining samples. */
  void expected(long furtherSamples);

  /**
   * Called with the other limits of the render.
   *
   * @param secondsLeft seconds until the time limit; empty if there is none
   * @param targetError target error, relative; empty if there is none
   */
  default void limited(Supplier<OptionalDouble> secondsLeft, OptionalDouble targetError) {}

  /** Called when more samples are finished. */
  void advanced(long samples);

  /** Called when the picture's relative error can be estimated; the estimate is costly. */
  default void estimable(Supplier<OptionalDouble> relativeError) {}

  @Override
  void close();
}
