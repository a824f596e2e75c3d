package io.github.lumbre.cli;

import java.util.OptionalDouble;
import java.util.function.Supplier;

/** Shows how far a render is. May be told from several threads at once. */
interface ProgressDisplay extends AutoCloseable {
  /** Shows nothing. */
  ProgressDisplay NONE =
      new ProgressDisplay() {
        @Override
        public void advanced(long samples) {}

        @Override
        public void close() {}
      };

  /** So many more samples are done. */
  void advanced(long samples);

  /** The picture's error, relative to the picture, can be estimated now, which takes a moment. */
  default void estimable(Supplier<OptionalDouble> relativeError) {}

  @Override
  void close();

  /**
   * Returns a bar on standard error, with rate and time left; nothing if the library that draws it
   * is missing or does not run here.
   */
  static ProgressDisplay bar(long totalSamples) {
    try {
      return new ProgressBarDisplay(totalSamples);
    } catch (LinkageError | RuntimeException e) {
      return NONE;
    }
  }
}
