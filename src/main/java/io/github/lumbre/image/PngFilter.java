package io.github.lumbre.image;

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
    int best = 0;
    long least = Long.MAX_VALUE;
    for (int filter = 0; filter < FILTERS; filter++) {
      long sum = filter(filter);
      if (sum < least) {
        least = sum;
        best = filter;
      }
    }
    out.write(filtered[best]);
  }

  /** Filters the row, and returns the sum of absolute differences. */
  private long filter(int filter) {
    byte[] result = filtered[filter];
    result[0] = (byte) filter;
    long sum = 0;
    for (int i = 0; i < length; i++) {
      int left = row[i] & 0xff;
      int up = above[i + bytesPerPixel] & 0xff;
      int predicted =
          switch (filter) {
            case 1 -> left;
            case 2 -> up;
            case 3 -> (left + up) / 2;
            case 4 -> paeth(left, up, above[i] & 0xff);
            default -> 0;
          };
      byte difference = (byte) (row[i + bytesPerPixel] - predicted);
      result[i + 1] = difference;
      sum += Math.abs(difference);
    }
    return sum;
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
