package io.github.lumbre.testing;

import java.security.SecureRandom;

/**
 * How hard tests try. In every build they are quick, and their seeds fixed; under {@code ./mvnw
 * verify -Pexhaustive} they draw as much as the law is to be trusted with, from a seed that is new
 * each time and printed, and {@code -Dlumbre.seed} repeats it. Tests that have no quick form carry
 * the tag {@link #EXHAUSTIVE}.
 */
public final class Effort {
  /** The JUnit tag of tests that only run under the profile of this name. */
  public static final String EXHAUSTIVE = "exhaustive";

  private static final boolean IS_EXHAUSTIVE = Boolean.getBoolean("lumbre.exhaustive");
  private static final String SEED = "lumbre.seed";
  private static final long RUN = run();

  private Effort() {}

  private static long run() {
    if (!IS_EXHAUSTIVE) {
      return 0;
    }
    Long given = Long.getLong(SEED);
    long run = given == null ? new SecureRandom().nextLong() : given;
    System.out.println("Exhaustive tests; to repeat them: -D" + SEED + "=" + run);
    return run;
  }

  /** Tells whether tests are to take their time. */
  public static boolean isExhaustive() {
    return IS_EXHAUSTIVE;
  }

  /** Returns how many rays, samples or cases a test is to draw. */
  public static int count(int quick, int exhaustive) {
    return IS_EXHAUSTIVE ? exhaustive : quick;
  }

  /** Returns the seed that a test is to draw from: the given one in a quick build. */
  public static long seed(long fixed) {
    return RUN ^ fixed;
  }
}
