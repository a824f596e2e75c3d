package io.github.lumbre.lab.checks;

import java.util.Objects;
import java.util.function.ToDoubleFunction;

/**
 * Something that must hold however extreme the scene, and how far it is from not holding.
 *
 * @param name short, in lower case, the same for ever
 * @param statement what is measured, with its unit
 * @param range over which it is tried
 * @param limit that the worst case may reach
 * @param measurement finds the worst case; NaN or infinite if something is badly wrong
 */
public record Invariant(
    String name,
    String statement,
    String range,
    double limit,
    ToDoubleFunction<Tries> measurement) {
  public Invariant {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(measurement, "measurement");
  }

  /** What was found of a law. */
  public record Outcome(Invariant law, double worst) {
    /** Tells whether the law holds. */
    public boolean holds() {
      return worst <= law.limit;
    }
  }

  /** Tries the law; takes seconds at most, times the tries. */
  public Outcome measure(Tries tries) {
    return new Outcome(this, measurement.applyAsDouble(tries));
  }
}
