package io.github.lumbre.light;

/**
 * An emitter chosen at random by a {@link LightSelector}. Mutable: each thread fills one and the
 * same again and again.
 */
public final class LightChoice {
  static final int WEIGHTS = 8;

  /** Memory for the weights of a few emitters. */
  final double[] weights = new double[WEIGHTS];

  private int emitter;
  private double probability;

  /** Makes the memory of a choice. */
  public LightChoice() {}

  void set(int newEmitter, double newProbability) {
    emitter = newEmitter;
    probability = newProbability;
  }

  /** Returns the emitter's index. */
  public int emitter() {
    return emitter;
  }

  /**
   * Returns the probability of this choice: what {@link LightSelector#probability} tells, for no
   * more work.
   */
  public double probability() {
    return probability;
  }
}
