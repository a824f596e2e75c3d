package io.github.lumbre.cli.option;

/**
 * How good a picture is to be, as the noise that ends its render and the depth of its paths;
 * docs/trade.md tells what each leaves wrong.
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

  /** Returns the relative root mean squared error to be reached. */
  public double targetError() {
    return targetError;
  }

  /** Returns how many vertices of a path may scatter. */
  public int depth() {
    return depth;
  }
}
