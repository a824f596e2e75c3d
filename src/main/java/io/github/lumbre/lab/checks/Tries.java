package io.github.lumbre.lab.checks;

/**
 * The number and the seed of an invariant's random test cases.
 *
 * @param times multiple of the cases of a quick test, at least 1
 * @param seed seed of the cases; 0 for the cases of {@code lumbre selftest}
 */
public record Tries(int times, long seed) {
  public Tries {
    if (times < 1) {
      throw new IllegalArgumentException("times: expected at least 1, found " + times);
    }
  }

  /** Returns the stream of random numbers for a key and the seed. */
  Draws draws(long key) {
    return new Draws(seed ^ key);
  }
}
