package io.github.lumbre.cli.output;

import java.util.OptionalDouble;
import java.util.function.Supplier;

/** Shows how far a render is. Safe for use by any thread. */
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

  /** A scene of this name is being read from now on, until {@link #started}. */
  default void reading(String name) {}

  /**
   * A render starts; no sample is done yet.
   *
   * @param totalSamples 0 if their number is not known
   */
  void started(long totalSamples);

  /** The running render will take about so many more samples. */
  void expected(long furtherSamples);

  /**
   * What else ends the render.
   *
   * @param secondsLeft until a time limit; empty without one
   * @param targetError relative to the picture; empty without one
   */
  default void limited(Supplier<OptionalDouble> secondsLeft, OptionalDouble targetError) {}

  /** So many more samples are done. */
  void advanced(long samples);

  /** The picture's error, relative to the picture, can be estimated now, which takes a moment. */
  default void estimable(Supplier<OptionalDouble> relativeError) {}

  @Override
  void close();
}
