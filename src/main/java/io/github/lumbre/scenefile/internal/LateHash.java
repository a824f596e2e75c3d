package io.github.lumbre.scenefile.internal;

import io.github.lumbre.math.internal.Sha256;
import java.util.function.Supplier;

/**
 * A SHA-256 that is computed when it is first asked for. Most short commands need none, and
 * compiling the code that hashes takes a seventh of their time. Until then, the bytes are kept, so
 * they must not change. Thread-safe.
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
