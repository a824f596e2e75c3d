package io.github.lumbre.render;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The number of samples of each primitive in each pixel: all of them, exactly. Mutable; different
 * threads may write different pixels.
 */
final class PrimitiveCounts {
  /** Bytes per pixel with at most one primitive: its entry, and a reference. */
  static final int BYTES_PER_PIXEL = Long.BYTES + Integer.BYTES;

  private static final long[] NONE = {};

  /**
   * The entry of the first primitive that was hit: its number plus one in the upper half, its count
   * in the lower half; 0 without one.
   */
  private final long[] first;

  /** The entries of the other primitives, sorted. */
  private final long[][] others;

  PrimitiveCounts(int pixels) {
    first = new long[pixels];
    others = new long[pixels][];
    Arrays.fill(others, NONE);
  }

  private static long entry(int primitive, int count) {
    return (primitive + 1L) << Integer.SIZE | count;
  }

  private static int primitive(long entry) {
    return (int) (entry >>> Integer.SIZE) - 1;
  }

  /** Returns the number of samples of each primitive that samples of a pixel hit, by its number. */
  Map<Integer, Integer> of(int pixel) {
    Map<Integer, Integer> counts = new LinkedHashMap<>();
    for (int i = 0; i < size(pixel); i++) {
      counts.put(primitive(pixel, i), count(pixel, i));
    }
    return counts;
  }

  /** Returns the number of primitives that samples of a pixel hit. */
  private int size(int pixel) {
    return first[pixel] == 0 ? 0 : 1 + others[pixel].length;
  }

  /**
   * Returns the number of a primitive in its scene.
   *
   * @param i 0 to {@link #size} - 1; the order has no meaning
   */
  private int primitive(int pixel, int i) {
    return primitive(entryAt(pixel, i));
  }

  /** Returns the number of samples that hit a primitive; see {@link #primitive(int, int)}. */
  private int count(int pixel, int i) {
    return (int) entryAt(pixel, i);
  }

  private long entryAt(int pixel, int i) {
    return i == 0 ? first[pixel] : others[pixel][i - 1];
  }

  /** Adds samples that hit a primitive; does nothing if primitives are not counted. */
  void add(int pixel, int primitive, int count) {
    if (first.length == 0) {
      return;
    }
    if (first[pixel] == 0) {
      first[pixel] = entry(primitive, count);
    } else if (primitive(first[pixel]) == primitive) {
      first[pixel] += count;
    } else {
      addToOthers(pixel, primitive, count);
    }
  }

  private void addToOthers(int pixel, int primitive, int count) {
    long[] entries = others[pixel];
    int place = -1 - Arrays.binarySearch(entries, entry(primitive, 0));
    if (place < entries.length && primitive(entries[place]) == primitive) {
      entries[place] += count;
      return;
    }
    long[] more = new long[entries.length + 1];
    System.arraycopy(entries, 0, more, 0, place);
    more[place] = entry(primitive, count);
    System.arraycopy(entries, place, more, place + 1, entries.length - place);
    others[pixel] = more;
  }

  void addAll(PrimitiveCounts other, int from, int to) {
    if (first.length == 0) {
      return;
    }
    for (int i = 0; i < other.size(from); i++) {
      add(to, other.primitive(from, i), other.count(from, i));
    }
  }

  void set(PrimitiveCounts other) {
    System.arraycopy(other.first, 0, first, 0, first.length);
    for (int i = 0; i < others.length; i++) {
      others[i] = other.others[i].length == 0 ? NONE : other.others[i].clone();
    }
  }

  int encodedBytes(int pixel) {
    return first.length == 0 ? 0 : FilmNumbers.MAX_BYTES * (1 + 2 * size(pixel));
  }

  /** Writes the number of primitives, then the number and the count of each, in their order. */
  void encode(int pixel, ByteBuffer out) {
    if (first.length == 0) {
      return;
    }
    long[] entries = new long[size(pixel)];
    for (int i = 0; i < entries.length; i++) {
      entries[i] = entryAt(pixel, i);
    }
    Arrays.sort(entries);
    FilmNumbers.put(out, entries.length);
    for (long entry : entries) {
      FilmNumbers.put(out, primitive(entry));
      FilmNumbers.put(out, (int) entry);
    }
  }

  /**
   * Reads a pixel in the format of {@link #encode}.
   *
   * @throws IllegalArgumentException if the bytes are not a valid pixel
   * @throws BufferUnderflowException if the bytes are truncated
   */
  void decode(int pixel, int samples, ByteBuffer in) {
    if (first.length == 0) {
      return;
    }
    int size = (int) FilmNumbers.get(in, samples);
    if (size > in.remaining()) {
      throw new BufferUnderflowException();
    }
    long[] entries = new long[size];
    int left = samples;
    int last = -1;
    for (int i = 0; i < size; i++) {
      int primitive = (int) FilmNumbers.get(in, Integer.MAX_VALUE - 1);
      int count = (int) FilmNumbers.get(in, left);
      if (primitive <= last || count == 0) {
        throw new IllegalArgumentException("expected primitives in their order, found others");
      }
      entries[i] = entry(primitive, count);
      last = primitive;
      left -= count;
    }
    first[pixel] = size == 0 ? 0 : entries[0];
    others[pixel] = size < 2 ? NONE : Arrays.copyOfRange(entries, 1, size);
  }
}
