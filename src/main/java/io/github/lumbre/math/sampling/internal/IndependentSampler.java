package io.github.lumbre.math.sampling.internal;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;

/**
 * A sampler of independent random numbers, each a hash of its address. It is the reference against
 * which {@link SobolSampler} is measured. Mutable and confined to one thread.
 */
public final class IndependentSampler implements Sampler {
  private final long seedKey;
  private long pixelKey;
  private int number;
  private long sampleKey;

  /**
   * Creates a sampler.
   *
   * @param seed any number; different seeds give different random numbers
   */
  public IndependentSampler(long seed) {
    seedKey = Hash.mix(seed + 0x9e3779b97f4a7c15L);
  }

  @Override
  public void startSample(int x, int y, int sample) {
    pixelKey = Hash.mix(seedKey ^ ((long) y << 32 | x & 0xffffffffL));
    number = sample;
    sampleKey = Hash.of(pixelKey, sample);
  }

  @Override
  public void startPart(int part, int parts) {
    sampleKey = Hash.of(pixelKey, number * parts + part);
  }

  @Override
  public double get1d(int dimension) {
    return Hash.unit(Hash.of(sampleKey, dimension));
  }

  @Override
  public Point2 get2d(int dimension) {
    return new Point2(get1d(dimension), get1d(dimension + 1));
  }
}
