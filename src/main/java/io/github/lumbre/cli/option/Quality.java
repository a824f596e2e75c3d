package io.github.lumbre.cli.option;

/**
 * Quality presets: a target error that ends the render, and a maximum path depth. docs/trade.md
 * lists the error that each one leaves.
 */
public enum Quality {
  DRAFT(.2, 3),
  PREVIEW(.1, 5),
  FINAL(.03, 16),
  REFERENCE(.01, 1000);

  private final double targetError;
  private final int depth;

  Quality(double targetError, int depth) {
    this.targetError = targetError;
    this.depth = depth;
  }

  /** Returns the target error, a relative root mean squared error. */
  public double targetError() {
    return targetError;
  }

  /** Returns the largest number of scattering vertices of a path. */
  public int depth() {
    return depth;
  }
}
