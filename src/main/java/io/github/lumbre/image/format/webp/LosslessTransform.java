package io.github.lumbre.image.format.webp;

import io.github.lumbre.base.limit.internal.Interrupts;

/**
 * A transform of the lossless format (RFC 9649, sec. 3.5), which is undone here. Pixels are ARGB.
 *
 * @param kind 0 prediction, 1 color, 2 subtracted green, 3 color index
 * @param width of the pixels after it is undone
 * @param bits the binary logarithm of the side of a block, or of the number of pixels in an index
 * @param data a pixel for each block, or the palette
 */
record LosslessTransform(int kind, int width, int bits, int[] data) {
  static final int PREDICTION = 0;
  static final int COLOR = 1;
  static final int GREEN = 2;
  static final int INDEX = 3;

  /** Returns the number of blocks that cover some pixels. */
  static int blocks(int pixels, int bits) {
    return pixels + (1 << bits) - 1 >> bits;
  }

  /** Undoes the transform in place. */
  void undo(int[] pixels, int height) {
    for (int i = 0; i < height; i++) {
      Interrupts.check();
      switch (kind) {
        case PREDICTION -> LosslessPrediction.addTo(pixels, i, this);
        case COLOR -> undoColor(pixels, i);
        case GREEN -> addGreen(pixels, i);
        default -> look(pixels, height - 1 - i);
      }
    }
  }

  int block(int x, int y) {
    return data[(y >> bits) * blocks(width, bits) + (x >> bits)];
  }

  private void undoColor(int[] pixels, int y) {
    for (int x = 0; x < width; x++) {
      int factors = block(x, y);
      int pixel = pixels[y * width + x];
      int green = pixel >> 8;
      int red = (pixel >> 16) + product(factors, green);
      int blue = pixel + product(factors >> 8, green) + product(factors >> 16, red);
      pixels[y * width + x] = pixel & 0xff00ff00 | (red & 0xff) << 16 | blue & 0xff;
    }
  }

  private static int product(int factor, int color) {
    return (byte) factor * (byte) color >> 5;
  }

  private void addGreen(int[] pixels, int y) {
    for (int i = y * width; i < (y + 1) * width; i++) {
      int green = pixels[i] >> 8 & 0xff;
      int both = (pixels[i] & 0xff00ff) + (green << 16 | green);
      pixels[i] = pixels[i] & 0xff00ff00 | both & 0xff00ff;
    }
  }

  /**
   * Replaces indices by colors, from the last one to the first; a pixel may hold several indices.
   */
  private void look(int[] pixels, int y) {
    int indexBits = Byte.SIZE >> bits;
    int row = y * blocks(width, bits);
    for (int x = width - 1; x >= 0; x--) {
      int packed = pixels[row + (x >> bits)] >> 8 & 0xff;
      int shift = (x & (1 << bits) - 1) * indexBits;
      int index = packed >> shift & (1 << indexBits) - 1;
      pixels[y * width + x] = index < data.length ? data[index] : 0;
    }
  }
}
