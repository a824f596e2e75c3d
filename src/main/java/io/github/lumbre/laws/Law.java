package io.github.lumbre.laws;

import java.util.Objects;
import java.util.function.IntToDoubleFunction;

/**
 * Something that must hold however extreme the scene, and how far it is from not holding.
 *
 * @param name short, in lower case, the same for ever
 * @param statement what is measured, with its unit
 * @param range over which it is tried
 * @param limit that the worst case may reach
 * @param measurement finds the worst case, in so many times the fewest tries; NaN or infinite if
 *     something is badly wrong
 */
public record Law(
    String name, String statement, String range, double limit, IntToDoubleFunction measurement) {
  public Law {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(measurement, "measurement");
  }

  /** What was found of a law. */
  public record Outcome(Law law, double worst) {
    /** Tells whether the law holds. */
    public boolean holds() {
      return worst <= law.limit;
    }
  }

  /**
   * Tries the law; takes seconds at most.
   *
   * @param effort at least 1: how many times as many random cases are tried as in a quick test
   */
  public Outcome measure(int effort) {
    return new Outcome(this, measurement.applyAsDouble(effort));
  }
}
