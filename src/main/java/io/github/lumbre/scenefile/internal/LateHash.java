package io.github.lumbre.scenefile.internal;

import io.github.lumbre.math.internal.Sha256;
import java.util.function.Supplier;

/**
 * A SHA-256 that is computed when it is first asked for: to compile its code takes a seventh of a
 * short command, most of which need no hash. Until then it holds what is hashed. Thread-safe.
 */
public final class LateHash {
  /** The largest number of bytes that wait in memory; what goes beyond is hashed at once. */
  public static final int MOST_WAITING = 1 << 24;

  private Supplier<String> source;

  /**
   * Creates a hash.
   *
   * @param source returns the hash in hexadecimal; it is called once at most
   */
  public LateHash(Supplier<String> source) {
    this.source = source;
  }

  /** Returns the hash of bytes, which do not change. */
  public static LateHash of(byte[] bytes) {
    return new LateHash(() -> Sha256.of(bytes));
  }

  /** Returns the hash in hexadecimal. */
  public synchronized String value() {
    String known = source.get();
    source = () -> known;
    return known;
  }
}
