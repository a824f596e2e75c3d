package io.github.lumbre.image.format.png;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.io.IOException;
import java.io.OutputStream;

/**
 * The filters of a PNG file's rows (PNG specification, third edition, section 9). Each row gets the
 * filter with the least sum of absolute differences, as section 12.7 advises. Mutable.
 */
final class PngFilter {
  private static final int FILTERS = 5;

  private final int bytesPerPixel;
  private final int length;

  /** A row and the one above it, with a pixel of zeros before the first one. */
  private byte[] row;

  private byte[] above;

  /** The filtered row of each filter, after the filter's number. */
  private final byte[][] filtered;

  /**
   * @param length the number of bytes in a row
   */
  PngFilter(int bytesPerPixel, int length) {
    this.bytesPerPixel = bytesPerPixel;
    this.length = length;
    row = new byte[bytesPerPixel + length];
    above = new byte[bytesPerPixel + length];
    filtered = new byte[FILTERS][1 + length];
    for (int filter = 0; filter < FILTERS; filter++) {
      filtered[filter][0] = (byte) filter;
    }
  }

  /** Returns the next row, to be filled from {@link #start} on. */
  byte[] nextRow() {
    byte[] next = above;
    above = row;
    row = next;
    return row;
  }

  /** Returns the index of a row's first byte. */
  int start() {
    return bytesPerPixel;
  }

  /** Writes the row that {@link #nextRow} has returned. */
  void write(OutputStream out) throws IOException {
    long[] sums = filter();
    int best = 0;
    for (int filter = 1; filter < FILTERS; filter++) {
      if (sums[filter] < sums[best]) {
        best = filter;
      }
    }
    out.write(filtered[best]);
  }

  /** Filters the row with all filters, and returns the sums of absolute differences. */
  private long[] filter() {
    byte[] none = filtered[0];
    byte[] sub = filtered[1];
    byte[] up = filtered[2];
    byte[] average = filtered[3];
    byte[] paeth = filtered[4];
    long[] sums = new long[FILTERS];
    for (int i = 0; i < length; i++) {
      int value = row[i + bytesPerPixel];
      int left = row[i] & 0xff;
      int top = above[i + bytesPerPixel] & 0xff;
      int corner = above[i] & 0xff;
      sums[0] += put(none, i + 1, value);
      sums[1] += put(sub, i + 1, value - left);
      sums[2] += put(up, i + 1, value - top);
      sums[3] += put(average, i + 1, value - (left + top) / 2);
      sums[4] += put(paeth, i + 1, value - paeth(left, top, corner));
    }
    return sums;
  }

  /** Stores a byte, and returns its absolute value as a signed one. */
  private static int put(byte[] bytes, int at, int value) {
    bytes[at] = (byte) value;
    return Math.abs(bytes[at]);
  }

  /**
   * Undoes the filter of a row.
   *
   * @param filter the number of the filter
   * @param row a pixel of zeros, and the filtered row
   * @param above a pixel of zeros, and the row above
   */
  static void undo(int filter, byte[] row, byte[] above, int bytesPerPixel)
      throws ImageFormatException {
    int end = row.length - bytesPerPixel;
    switch (filter) {
      case 0 -> {}
      case 1 -> {
        for (int i = 0; i < end; i++) {
          row[i + bytesPerPixel] += row[i];
        }
      }
      case 2 -> {
        for (int i = bytesPerPixel; i < row.length; i++) {
          row[i] += above[i];
        }
      }
      case 3 -> {
        for (int i = 0; i < end; i++) {
          row[i + bytesPerPixel] +=
              (byte) ((row[i] & 0xff) + (above[i + bytesPerPixel] & 0xff) >> 1);
        }
      }
      case 4 -> {
        for (int i = 0; i < end; i++) {
          int top = above[i + bytesPerPixel] & 0xff;
          row[i + bytesPerPixel] += (byte) paeth(row[i] & 0xff, top, above[i] & 0xff);
        }
      }
      default -> throw malformed("PNG is damaged: the unknown filter " + filter);
    }
  }

  /** Returns which of the three is nearest to {@code left + up - corner}. */
  private static int paeth(int left, int up, int corner) {
    int toLeft = Math.abs(up - corner);
    int toUp = Math.abs(left - corner);
    int toCorner = Math.abs(left + up - 2 * corner);
    if (toLeft <= toUp && toLeft <= toCorner) {
      return left;
    }
    return toUp <= toCorner ? up : corner;
  }
}
