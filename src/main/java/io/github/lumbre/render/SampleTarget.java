package io.github.lumbre.render;

/** How many samples each pixel is to have in all, those that it has already included. */
@FunctionalInterface
public interface SampleTarget {
  /**
   * Returns the number for a pixel of the full frame, 0 to 2^30. Asked by worker threads, any of
   * them at once, each time a pixel's turn comes in a pass.
   */
  int samples(int x, int y);

  /**
   * Hears how many rays the samples took that a pixel was given, all kinds of rays together. Told
   * by worker threads, each of them of other pixels, also of a pixel whose turn was cut short.
   *
   * @param rays at least 0, the same for the same samples on every machine
   */
  default void took(int x, int y, long rays) {}
}
