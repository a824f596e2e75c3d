package io.github.lumbre.sampling;

/** Integer hashes: random numbers as pure functions of what they are for. */
public final class Hash {
  private static final long GOLDEN = 0x9e3779b97f4a7c15L;

  private Hash() {}

  /** The 64-bit finaliser of SplitMix64 (Steele et al. 2014; constants: Stafford's variant 13). */
  public static long mix(long z) {
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }

  /**
   * Returns the hash of a number under a key. Of one key, different numbers have different hashes:
   * they are the outputs of SplitMix64, seeded with the key, by their position.
   */
  public static long of(long key, long number) {
    return mix(key + number * GOLDEN);
  }

  /** Returns the number in [0,1), a multiple of 2^-53, that a hash stands for. */
  public static double unit(long hash) {
    return (hash >>> 11) * 0x1p-53;
  }
}
