package io.github.lumbre.image.format.png;

import java.util.stream.IntStream;

/**
 * The transparency of a PNG file without an alpha channel: alpha for each color of a palette, or
 * one transparent color (PNG specification, third edition, section 11.3.1.1).
 *
 * @param type the color type of the file
 * @param depth bits per sample
 * @param data of the chunk tRNS; empty if the file has none
 */
record PngTransparency(int type, int depth, byte[] data) {
  private static final int GRAY = 0;
  private static final int RGB = 2;
  private static final int PALETTE = 3;
  private static final int OPAQUE = 255;

  /** Returns whether any color may be transparent. A chunk of a wrong size is ignored. */
  public boolean isPresent() {
    return switch (type) {
      case GRAY -> data.length == 2;
      case RGB -> data.length == 6;
      case PALETTE -> data.length > 0;
      default -> false;
    };
  }

  /** Returns the transparent color as samples: one of gray, or three; empty if there is none. */
  public int[] key() {
    if (!isPresent() || type == PALETTE) {
      return new int[0];
    }
    return IntStream.range(0, data.length / 2)
        .map(i -> (data[2 * i] << 8 | data[2 * i + 1] & 0xff) & (1 << depth) - 1)
        .toArray();
  }

  /**
   * Returns the alpha of a color of a palette, from 0 to 255.
   *
   * @param index of the color
   */
  public int alpha(int index) {
    return index < data.length ? data[index] & 0xff : OPAQUE;
  }
}
