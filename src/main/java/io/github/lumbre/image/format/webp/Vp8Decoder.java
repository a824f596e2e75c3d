package io.github.lumbre.image.format.webp;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;

/** Decodes a VP8 key frame (RFC 6386). Mutable. */
final class Vp8Decoder {
  private static final int SIDE = 16;

  /** The number of pixels of a macroblock. */
  static final int MACROBLOCK = SIDE * SIDE;

  private final int columns;
  private final int rows;
  private final Vp8Header header;
  private final Vp8Modes modes;
  private final Vp8Coefficients coefficients;
  private final Vp8Prediction prediction = new Vp8Prediction();
  private final Vp8Plane[] planes;

  private Vp8Decoder(Vp8Header header, int width, int height) {
    columns = (width + SIDE - 1) / SIDE;
    rows = (height + SIDE - 1) / SIDE;
    this.header = header;
    modes = new Vp8Modes(header, columns);
    coefficients = new Vp8Coefficients(header, columns);
    planes = new Vp8Plane[] {plane(SIDE), plane(SIDE / 2), plane(SIDE / 2)};
  }

  private Vp8Plane plane(int side) {
    return new Vp8Plane(columns * side, rows * side);
  }

  /**
   * Returns the planes of a frame: luma, and chroma of half the resolution, in whole macroblocks.
   *
   * @param from the position of the frame in the file
   * @param end the position after it
   */
  static Vp8Plane[] decode(byte[] file, int from, int end, int width, int height)
      throws ImageFormatException {
    return new Vp8Decoder(Vp8Header.read(file, from, end), width, height).decode();
  }

  private Vp8Plane[] decode() throws ImageFormatException {
    byte[] filters = new byte[columns * rows];
    BoolDecoder[] residuals = header.residuals();
    for (int row = 0; row < rows; row++) {
      Interrupts.check();
      modes.startRow();
      coefficients.startRow(residuals[row % residuals.length]);
      for (int column = 0; column < columns; column++) {
        modes.read(column);
        int segment = modes.segment();
        boolean found = coefficients.read(column, modes, header.quantizers()[segment]);
        filters[row * columns + column] =
            header.filters().code(segment, modes.isSplit(), modes.isSplit() || found);
        reconstruct(column, row);
      }
    }
    // Predictions read samples before they are smoothed.
    header.filters().apply(filters, columns, planes);
    return planes;
  }

  private void reconstruct(int column, int row) {
    int x = column * SIDE;
    int y = row * SIDE;
    if (modes.isSplit()) {
      reconstructBlocks(x, y);
    } else {
      Vp8Prediction.predict(planes[0], x, y, SIDE, modes.luma());
      addResiduals(planes[0], x, y, SIDE, 0);
    }
    for (int i = 1; i <= 2; i++) {
      Vp8Prediction.predict(planes[i], x / 2, y / 2, SIDE / 2, modes.chroma());
      addResiduals(planes[i], x / 2, y / 2, SIDE / 2, 12 + 4 * i);
    }
  }

  private void addResiduals(Vp8Plane plane, int x, int y, int side, int firstBlock) {
    int from = firstBlock * Vp8Coefficients.BLOCK;
    for (int dy = 0; dy < side; dy += 4) {
      for (int dx = 0; dx < side; dx += 4, from += Vp8Coefficients.BLOCK) {
        Vp8Transform.add(coefficients.values(), from, plane, x + dx, y + dy);
      }
    }
  }

  private void reconstructBlocks(int x, int y) {
    Vp8Plane plane = planes[0];
    // What is right of the last column repeats its last sample, but not above the picture.
    boolean repeats = x / SIDE == columns - 1;
    int beside = plane.at(x + SIDE - (repeats ? 1 : 0), y - 1);
    for (int i = 0; i < SIDE; i++) {
      int blockX = x + i % 4 * 4;
      int blockY = y + i / 4 * 4;
      boolean isLast = i % 4 == 3;
      int right = isLast ? beside : plane.at(blockX + 4, blockY - 1);
      int step = isLast && repeats ? 0 : 1;
      prediction.predictBlock(plane, blockX, blockY, modes.block(i), right, step);
      Vp8Transform.add(coefficients.values(), i * Vp8Coefficients.BLOCK, plane, blockX, blockY);
    }
  }
}
