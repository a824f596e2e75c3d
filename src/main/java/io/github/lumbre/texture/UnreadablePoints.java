package io.github.lumbre.texture;

/**
 * Counts the points at which textures are evaluated and that are not finite, as of coordinates near
 * the largest number times a scale. Textures are evaluated at (0, 0) there, which is wrong but
 * harmless; a render reports how many there were.
 *
 * <p>Each thread has a count of its own, and a thread works for one render at a time: so renders
 * never see each other's points, even of the same textures, and no argument is needed on the way to
 * every texture.
 */
public final class UnreadablePoints {
  private static final ThreadLocal<long[]> COUNT = ThreadLocal.withInitial(() -> new long[1]);

  private UnreadablePoints() {}

  static void count() {
    COUNT.get()[0]++;
  }

  /** Returns how many there were in this thread since this was last called. */
  public static long take() {
    long count = COUNT.get()[0];
    COUNT.remove();
    return count;
  }
}
