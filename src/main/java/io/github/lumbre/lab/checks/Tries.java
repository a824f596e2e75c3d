package io.github.lumbre.lab.checks;

/**
 * How much of the random cases of a law is tried, and which.
 *
 * @param times at least 1: as many as that times the cases of a quick test
 * @param seed 0 for the cases of {@code lumbre selftest}; another for others
 */
public record Tries(int times, long seed) {
  public Tries {
    if (times < 1) {
      throw new IllegalArgumentException("times: expected at least 1, found " + times);
    }
  }

  /** Returns a stream of numbers that are others for another key or seed. */
  Draws draws(long key) {
    return new Draws(seed ^ key);
  }
}
