package io.github.lumbre.math.sampling.internal;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;

/**
 * A sampler of Owen-scrambled Sobol points. Every pair of dimensions is its own shuffled and
 * scrambled copy of the first two Sobol dimensions. The points are well distributed for any number
 * of samples, and stratified for every power of two. The number of samples need not be known
 * beforehand. Mutable and confined to one thread.
 *
 * <p>Burley 2020, "Practical Hash-based Owen Scrambling". The scrambling hash is Vegdahl's
 * improvement of the Laine–Karras hash.
 */
public final class SobolSampler implements Sampler {
  /** Identifies this sampler and its sequence of numbers; changes whenever the numbers change. */
  public static final String ID = "owen-sobol 1";

  private static final double ULP32 = 0x1p-32;

  private final long seedKey;
  private long pixelKey;
  private int number;
  private int reversedIndex;

  public SobolSampler(long seed) {
    seedKey = Hash.mix(seed + 0x9e3779b97f4a7c15L);
  }

  @Override
  public void startSample(int x, int y, int sample) {
    pixelKey = Hash.mix(seedKey ^ ((long) y << 32 | x & 0xffffffffL));
    number = sample;
    reversedIndex = Integer.reverse(sample);
  }

  @Override
  public void startPart(int part, int parts) {
    reversedIndex = Integer.reverse(number * parts + part);
  }

  @Override
  public double get1d(int dimension) {
    long key = Hash.mix(pixelKey + dimension * 0xd1b54a32d192ed03L);
    int index = Integer.reverse(scramble(reversedIndex, (int) key));
    // The base-2 radical inverse of the shuffled index is its reversed bits.
    return unit(Integer.reverse(scramble(index, (int) (key >>> 32))));
  }

  @Override
  public Point2 get2d(int dimension) {
    long key = Hash.mix(pixelKey + dimension * 0xd1b54a32d192ed03L);
    int index = Integer.reverse(scramble(reversedIndex, (int) key));
    int high = (int) (key >>> 32);
    int x = scramble(index, high);
    int y = scramble(reversedSecondDimension(index), mix32(high));
    // Reverse both at once.
    long both = Long.reverse((long) y << 32 | x & 0xffffffffL);
    return new Point2(unit((int) (both >>> 32)), unit((int) both));
  }

  /**
   * Returns the center of the interval of length 2^-32 that 32 random bits represent, so that means
   * are exact.
   */
  private static double unit(int bits) {
    return ((bits & 0xffffffffL) + .5) * ULP32;
  }

  /**
   * Returns the second Sobol dimension of an index, with its bits reversed. The generator matrix is
   * Pascal's triangle modulo 2, a Kronecker power of [1 1; 0 1], so that five shifts replace 32
   * table rows.
   */
  static int reversedSecondDimension(int index) {
    int v = index;
    v ^= (v & 0xaaaaaaaa) >>> 1;
    v ^= (v & 0xcccccccc) >>> 2;
    v ^= (v & 0xf0f0f0f0) >>> 4;
    v ^= (v & 0xff00ff00) >>> 8;
    v ^= v >>> 16;
    return v;
  }

  /** Returns a bit-reversed number after Owen scrambling by the Laine–Karras hash. */
  static int scramble(int x, int key) {
    x ^= x * 0x3d20adea;
    x += key;
    x *= (key >>> 16) | 1;
    x ^= x * 0x05526c56;
    x ^= x * 0x53a22864;
    return x;
  }

  private static int mix32(int x) {
    x = (x ^ (x >>> 16)) * 0x7feb352d;
    x = (x ^ (x >>> 15)) * 0x846ca68b;
    return x ^ (x >>> 16);
  }
}
