package io.github.lumbre.base.limit;

import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;

/**
 * Limits for untrusted scenes and models. Readers compare them with what a file claims before they
 * allocate memory or work. They come in addition to the limits that hold for every file, which
 * protect the program and not its neighbors. Immutable.
 *
 * @param bytes of all files that a scene or model consists of, at least 1
 * @param pixels of the rendered frame, at least 1
 * @param texels of all pictures that a scene decodes, at least 0
 * @param triangles of all meshes, counted once for each use, at least 0
 * @param samples per pixel, at least 1
 * @param memory heap bytes for the scene, and again for the film; at least 1. What is read is
 *     estimated from counts, so it is a bound of the order of magnitude
 * @param time of reading, and again of rendering, more than 0
 * @param legacyPictures whether BMP, GIF and TIFF pictures are read; they are decoded by parts of
 *     Java that are seldom used, and so less tested than those for PNG and JPEG
 */
public record Limits(
    long bytes,
    long pixels,
    long texels,
    long triangles,
    long samples,
    long memory,
    Duration time,
    boolean legacyPictures) {
  /** A time that no process reaches: 200 years. */
  public static final Duration NO_TIME_LIMIT = Duration.ofDays(200 * 365L);

  /** No limits but those that hold for every file. */
  public static final Limits NONE =
      new Limits(
          Long.MAX_VALUE,
          Long.MAX_VALUE,
          Long.MAX_VALUE,
          Long.MAX_VALUE,
          Long.MAX_VALUE,
          Long.MAX_VALUE,
          NO_TIME_LIMIT,
          true);

  /**
   * For a picture of an upload: 64 MiB of files, 2^22 pixels, 2^26 texels, 2 million triangles, 256
   * samples per pixel, 512 MiB of memory, 20 seconds, no BMP, GIF and TIFF pictures.
   */
  public static final Limits UPLOADS =
      new Limits(
          64L << 20, 1L << 22, 1L << 26, 2_000_000, 256, 512L << 20, Duration.ofSeconds(20), false);

  public Limits {
    requireAtLeast(1, bytes, "bytes");
    requireAtLeast(1, pixels, "pixels");
    requireAtLeast(0, texels, "texels");
    requireAtLeast(0, triangles, "triangles");
    requireAtLeast(1, samples, "samples");
    requireAtLeast(1, memory, "memory");
    Objects.requireNonNull(time, "time");
    if (time.isNegative() || time.isZero() || time.compareTo(NO_TIME_LIMIT) > 0) {
      throw new IllegalArgumentException(
          "time: expected more than 0 s and at most 200 years, found " + time);
    }
  }

  private static void requireAtLeast(long least, long found, String name) {
    if (found < least) {
      throw new IllegalArgumentException(
          name + ": expected at least " + least + ", found " + found);
    }
  }

  /** Returns these limits with another {@link #bytes}. */
  public Limits withBytes(long value) {
    return new Limits(value, pixels, texels, triangles, samples, memory, time, legacyPictures);
  }

  /** Returns these limits with another {@link #pixels}. */
  public Limits withPixels(long value) {
    return new Limits(bytes, value, texels, triangles, samples, memory, time, legacyPictures);
  }

  /** Returns these limits with another {@link #texels}. */
  public Limits withTexels(long value) {
    return new Limits(bytes, pixels, value, triangles, samples, memory, time, legacyPictures);
  }

  /** Returns these limits with another {@link #triangles}. */
  public Limits withTriangles(long value) {
    return new Limits(bytes, pixels, texels, value, samples, memory, time, legacyPictures);
  }

  /** Returns these limits with another {@link #samples}. */
  public Limits withSamples(long value) {
    return new Limits(bytes, pixels, texels, triangles, value, memory, time, legacyPictures);
  }

  /** Returns these limits with another {@link #memory}. */
  public Limits withMemory(long value) {
    return new Limits(bytes, pixels, texels, triangles, samples, value, time, legacyPictures);
  }

  /** Returns these limits with another {@link #time}. */
  public Limits withTime(Duration value) {
    return new Limits(bytes, pixels, texels, triangles, samples, memory, value, legacyPictures);
  }

  /** Returns these limits with another {@link #legacyPictures}. */
  public Limits withLegacyPictures(boolean value) {
    return new Limits(bytes, pixels, texels, triangles, samples, memory, time, value);
  }

  /** Returns whether the bytes of files are limited, as in {@link #UPLOADS}. */
  public boolean hasLimitedBytes() {
    return bytes < Long.MAX_VALUE / 2;
  }

  /**
   * Returns the bytes of a stream to its end, or one more than {@link #bytes}, which readers
   * refuse.
   *
   * @throws IOException if the stream fails
   */
  public byte[] bytesOf(InputStream stream) throws IOException {
    return stream.readNBytes((int) Math.min(bytes, Integer.MAX_VALUE - 9) + 1);
  }

  /** Returns the heap bytes that reading may use: {@link #memory}, but not more than the heap. */
  public long heap() {
    return Math.min(memory, Runtime.getRuntime().maxMemory());
  }

  /**
   * Returns a message about a number that exceeds its limit; empty if it does not.
   *
   * @param things the counted things, in the plural
   */
  public static Optional<String> excess(String things, long max, long found) {
    return found <= max
        ? Optional.empty()
        : Optional.of("expected at most " + max + " " + things + ", found " + found);
  }
}
