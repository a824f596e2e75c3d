package io.github.lumbre.testing;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * A sampler that returns given values, the same for every pixel and sample, and records the
 * requested dimensions. Other dimensions are an error. Mutable.
 */
public final class ScriptedSampler implements Sampler {
  private final Map<Integer, Double> values = new HashMap<>();
  private final Set<Integer> asked = new HashSet<>();

  /** Sets the values from one dimension on, and returns this. */
  public ScriptedSampler with(int dimension, double... numbers) {
    for (int i = 0; i < numbers.length; i++) {
      values.put(dimension + i, numbers[i]);
    }
    return this;
  }

  /** Returns the dimensions requested so far. */
  public Set<Integer> asked() {
    return Set.copyOf(asked);
  }

  @Override
  public void startSample(int x, int y, int sample) {}

  @Override
  public void startPart(int part, int parts) {}

  @Override
  public double get1d(int dimension) {
    asked.add(dimension);
    Double value = values.get(dimension);
    if (value == null) {
      throw new AssertionError("dimension " + dimension + " was asked for");
    }
    return value;
  }

  @Override
  public Point2 get2d(int dimension) {
    return new Point2(get1d(dimension), get1d(dimension + 1));
  }
}
