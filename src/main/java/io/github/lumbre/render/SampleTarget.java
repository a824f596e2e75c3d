package io.github.lumbre.render;

/** The target number of samples of each pixel, including the samples that it already has. */
@FunctionalInterface
public interface SampleTarget {
  /**
   * Returns the target of a pixel of the full frame, 0 to 2^30. Worker threads call this, possibly
   * at once, before they render the pixel.
   */
  int samples(int x, int y);

  /**
   * Receives the number of rays, of all kinds, that the new samples of a pixel needed. Worker
   * threads call this, each for different pixels, also for a pixel whose rendering was cancelled.
   *
   * @param rays at least 0; the same for the same samples on every machine
   */
  default void took(int x, int y, long rays) {}
}
