package io.github.lumbre.light;

/** Which of a scene's emitters a point asks for light. Immutable. */
public interface LightSelector {
  /** Returns the index of an emitter, chosen by a uniform number in [0,1). */
  int choose(double u);

  /** Returns the probability with which {@link #choose} returns an index; positive. */
  double probability(int index);

  /**
   * Returns the selector that gives each of n emitters the same chance.
   *
   * @param n at least 1
   */
  static LightSelector uniform(int n) {
    if (n < 1) {
      throw new IllegalArgumentException("n: expected at least 1, found " + n);
    }
    return new LightSelector() {
      @Override
      public int choose(double u) {
        return (int) (u * n);
      }

      @Override
      public double probability(int index) {
        return 1.0 / n;
      }
    };
  }
}
