package io.github.lumbre.model.internal;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/**
 * Estimates the heap that a model takes until its scene is rendered, by its triangles. Pictures of
 * textures and the film come in addition. Stateless.
 */
public final class HeapNeed {
  /**
   * Heap bytes of a triangle of a mesh with shared vertices, at least, while the hierarchy of its
   * scene is built. A point takes about as many.
   */
  private static final long BYTES_PER_TRIANGLE = 140;

  /** The bytes of a file in which its counts are sought. */
  private static final int START = 4 << 20;

  /** Smaller files take too little heap to say so: they have too few triangles. */
  private static final long SMALL_FILE = 1 << 19;

  /** Less than this is not worth a line, unless it is a tenth of the heap. */
  private static final long NOTICEABLE = 100L << 20;

  private HeapNeed() {}

  /**
   * Returns the heap bytes that a model takes.
   *
   * @param items triangles of all meshes, each counted once, and points
   */
  public static long bytes(long items) {
    return BYTES_PER_TRIANGLE * items;
  }

  /** Returns a number of bytes of the heap in words, such as "about 134 MiB of heap". */
  public static String text(long bytes) {
    return "about %d MiB of the heap of %d MiB"
        .formatted((bytes >> 20) + 1, Runtime.getRuntime().maxMemory() >> 20);
  }

  /**
   * Returns a line about the heap that the model of a file will take, before it is read; empty if
   * that is little, or the start of the file does not state it.
   */
  public static Optional<String> note(Path file) {
    long items;
    try {
      items = Files.size(file) < SMALL_FILE ? 0 : items(file);
    } catch (IOException e) {
      // Reading the file reports the error.
      return Optional.empty();
    }
    long bytes = bytes(items);
    return bytes < Math.min(NOTICEABLE, Runtime.getRuntime().maxMemory() / 10)
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT, "%s: %d triangles take %s", file, items, text(bytes)));
  }

  /**
   * Returns the number of triangles, or of points, that the start of a model's file states; 0 if it
   * states none.
   *
   * @throws IOException if the file cannot be read
   */
  static long items(Path file) throws IOException {
    long size = Files.size(file);
    byte[] start;
    try (InputStream in = Files.newInputStream(file)) {
      start = in.readNBytes(START);
    }
    String name = String.valueOf(file.getFileName());
    return ModelFormat.named(name)
        .or(() -> ModelFormat.in(start, size))
        .map(format -> format.items(start, size))
        .orElse(0L);
  }
}
