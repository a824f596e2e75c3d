package io.github.lumbre.texture.internal;

/**
 * Counts invalid texture coordinates: NaN or infinite, for example after a huge coordinate is
 * scaled. Textures are evaluated at (0, 0) instead, which is wrong but harmless. A render reports
 * their number.
 *
 * <p>Each thread has its own count, and works for one render at a time. Renders therefore never
 * count each other's points, even with shared textures, and texture evaluation needs no extra
 * argument.
 */
public final class InvalidCoordinates {
  private static final ThreadLocal<long[]> COUNT = ThreadLocal.withInitial(() -> new long[1]);

  private InvalidCoordinates() {}

  static void count() {
    COUNT.get()[0]++;
  }

  /** Returns the number of invalid points in this thread since the last call, and resets it. */
  public static long take() {
    long count = COUNT.get()[0];
    COUNT.remove();
    return count;
  }
}
