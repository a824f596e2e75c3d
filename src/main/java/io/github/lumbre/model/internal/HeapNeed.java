package io.github.lumbre.model.internal;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Estimates the heap that a model takes until its scene is rendered. Pictures of textures and the
 * film come in addition.
 *
 * @param triangles of all meshes, each counted once
 * @param points of all clouds
 */
public record HeapNeed(long triangles, long points) {
  /** Of a file that does not state it. */
  public static final HeapNeed UNKNOWN = new HeapNeed(0, 0);

  /**
   * Heap bytes of a triangle of a mesh with shared vertices, at least, while the hierarchy of its
   * scene is built.
   */
  private static final long BYTES_PER_TRIANGLE = 140;

  /** The same of a point. */
  private static final long BYTES_PER_POINT = 270;

  /** The bytes of a file in which its counts are sought. */
  private static final int START = 4 << 20;

  /** A smaller file hardly takes {@link #NOTICEABLE} bytes of heap, unless it is compressed well. */
  private static final long SMALL_FILE = 2 << 20;

  /** Less than this is not worth a line, unless it is a tenth of the heap. */
  private static final long NOTICEABLE = 100L << 20;

  public static HeapNeed ofTriangles(long triangles) {
    return new HeapNeed(triangles, 0);
  }

  public static HeapNeed ofPoints(long points) {
    return new HeapNeed(0, points);
  }

  /** Returns the heap bytes that the model takes. */
  public long bytes() {
    return BYTES_PER_TRIANGLE * triangles + BYTES_PER_POINT * points;
  }

  /** Returns what the model consists of, such as "12 triangles". */
  String items() {
    return points == 0
        ? triangles + " triangles"
        : (triangles == 0 ? "" : triangles + " triangles and ") + points + " points";
  }

  /** Returns the bytes in words, such as "about 134 MiB". */
  public String text() {
    return "about " + ((bytes() >> 20) + 1) + " MiB";
  }

  /**
   * Returns a line about the heap that the model of a file will take, before it is read; empty if
   * that is little, or the start of the file does not state it.
   */
  public static Optional<String> note(Path file) {
    HeapNeed need;
    try {
      need = Files.size(file) < SMALL_FILE ? UNKNOWN : of(file);
    } catch (IOException e) {
      // Reading the file reports the error.
      return Optional.empty();
    }
    long heap = Runtime.getRuntime().maxMemory();
    return need.bytes() < Math.min(NOTICEABLE, heap / 10)
        ? Optional.empty()
        : Optional.of(
            "%s: %s take %s of the heap of %d MiB"
                .formatted(file, need.items(), need.text(), heap >> 20));
  }

  /**
   * Returns what the start of a model's file states.
   *
   * @throws IOException if the file cannot be read
   */
  static HeapNeed of(Path file) throws IOException {
    long size = Files.size(file);
    byte[] start;
    try (InputStream in = Files.newInputStream(file)) {
      start = in.readNBytes(START);
    }
    String name = String.valueOf(file.getFileName());
    return ModelFormat.named(name)
        .or(() -> ModelFormat.in(start, size))
        .map(format -> format.need(start, size))
        .orElse(UNKNOWN);
  }
}
