package io.github.lumbre.render;

/** How many samples each pixel is to have in all, those that it has already included. */
@FunctionalInterface
public interface SampleTarget {
  /**
   * Returns the number for a pixel of the full frame, 0 to 2^30. Asked by worker threads, any of
   * them at once, each time a pixel's turn comes in a pass.
   */
  int samples(int x, int y);
}
