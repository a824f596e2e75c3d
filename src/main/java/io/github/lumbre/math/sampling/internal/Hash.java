package io.github.lumbre.math.sampling.internal;

/** Integer hashes, which give random numbers as pure functions of a key and an index. */
public final class Hash {
  private static final long GOLDEN = 0x9e3779b97f4a7c15L;

  private Hash() {}

  /**
   * Returns the 64-bit finalizer of SplitMix64 (Steele et al. 2014; constants: Stafford's variant
   * 13).
   */
  public static long mix(long z) {
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }

  /**
   * Returns the hash of a number under a key. For one key, different numbers have different hashes:
   * hash n is the n-th output of SplitMix64 seeded with the key.
   */
  public static long of(long key, long number) {
    return mix(key + number * GOLDEN);
  }

  /**
   * Returns the number in [0,1) that a hash represents: its upper 53 bits as a multiple of 2^-53.
   */
  public static double unit(long hash) {
    return (hash >>> 11) * 0x1p-53;
  }
}
