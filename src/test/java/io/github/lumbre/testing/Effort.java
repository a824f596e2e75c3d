package io.github.lumbre.testing;

import java.security.SecureRandom;

/**
 * The effort of tests. Normal builds are quick and have fixed seeds. {@code ./mvnw verify
 * -Pexhaustive} uses many more samples and a new seed, which it prints; {@code -Dlumbre.seed}
 * repeats that seed. Tests without a quick form have the tag {@link #EXHAUSTIVE}.
 */
public final class Effort {
  /** The JUnit tag of tests that only run under the profile of this name. */
  public static final String EXHAUSTIVE = "exhaustive";

  private static final boolean IS_EXHAUSTIVE = Boolean.getBoolean("lumbre.exhaustive");

  /**
   * The system property that makes tests brief, so that they can judge each of many mutants of the
   * program.
   */
  public static final String BRIEF = "lumbre.brief";

  private static final boolean IS_BRIEF = Boolean.getBoolean(BRIEF);
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

  /** Returns whether this is an exhaustive run. */
  public static boolean isExhaustive() {
    return IS_EXHAUSTIVE;
  }

  /** Returns the number of rays, samples or cases of a test. */
  public static int count(int quick, int exhaustive) {
    return IS_EXHAUSTIVE ? exhaustive : quick;
  }

  /**
   * Returns a number of rays, samples or expected hits: a twentieth of the given number in brief
   * tests, otherwise that number.
   */
  public static int brief(int usual) {
    return IS_BRIEF ? usual / 20 : usual;
  }

  /** Returns the seed of a test: the given one in a quick build. */
  public static long seed(long fixed) {
    return RUN ^ fixed;
  }
}
