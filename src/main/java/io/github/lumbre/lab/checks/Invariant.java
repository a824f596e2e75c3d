package io.github.lumbre.lab.checks;

import java.util.Objects;

/**
 * A property that must hold for every scene, however extreme, with a measure of its worst
 * violation.
 *
 * @param name short name in lower case, never changed
 * @param statement what is measured, with its unit
 * @param range tested range
 * @param limit largest accepted value
 * @param measurement measures the worst case; NaN or infinite after an invalid result
 */
public record Invariant(
    String name, String statement, String range, double limit, Measurement measurement) {
  public Invariant {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(measurement, "measurement");
  }

  /** Measures a worst case. */
  public interface Measurement {
    /** Returns the worst case. */
    double worst(Tries tries) throws InterruptedException;
  }

  /** The result of measuring an invariant. */
  public record Outcome(Invariant law, double worst) {
    public boolean holds() {
      return worst <= law.limit;
    }
  }

  /**
   * Measures the invariant; takes at most a few seconds times the number of tries.
   *
   * @throws InterruptedException if the calling thread is interrupted
   */
  public Outcome measure(Tries tries) throws InterruptedException {
    return new Outcome(this, measurement.worst(tries));
  }
}
