package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LowBits;
import java.util.ArrayDeque;
import java.util.Deque;

/** Decodes a lossless picture (RFC 9649, sec. 3). Mutable. */
final class LosslessDecoder {
  private final LowBits bits;
  private final int height;
  private final Deque<LosslessTransform> transforms = new ArrayDeque<>();

  /** The width of the stored pixels: smaller than the picture's, if they are packed indices. */
  private int width;

  private LosslessDecoder(LowBits bits, int width, int height) {
    this.bits = bits;
    this.width = width;
    this.height = height;
  }

  /** Returns the pixels as ARGB, row by row. */
  static int[] decode(LowBits bits, int width, int height) throws ImageFormatException {
    return new LosslessDecoder(bits, width, height).decode(new int[width * height]);
  }

  private int[] decode(int[] pixels) throws ImageFormatException {
    int kinds = 0;
    while (bits.flag()) {
      int kind = bits.read(2);
      if ((kinds >> kind & 1) == 1) {
        throw malformed("WebP is damaged: a transform occurs twice");
      }
      kinds |= 1 << kind;
      readTransform(kind);
    }
    new LosslessPixels(bits, width, height).readWithGroups(pixels);
    for (LosslessTransform transform : transforms) {
      transform.undo(pixels, height);
    }
    return pixels;
  }

  private void readTransform(int kind) throws ImageFormatException {
    int size = 0;
    int[] data = {};
    int unpacked = width;
    if (kind == LosslessTransform.INDEX) {
      int colors = 1 + bits.read(8);
      data = LosslessPixels.read(bits, colors, 1);
      for (int i = 1; i < colors; i++) {
        data[i] = LosslessPrediction.sum(data[i], data[i - 1]);
      }
      size = colors > 16 ? 0 : colors > 4 ? 1 : colors > 2 ? 2 : 3;
      width = LosslessTransform.blocks(width, size);
    } else if (kind != LosslessTransform.GREEN) {
      size = 2 + bits.read(3);
      data =
          LosslessPixels.read(
              bits, LosslessTransform.blocks(width, size), LosslessTransform.blocks(height, size));
    }
    transforms.push(new LosslessTransform(kind, unpacked, size, data));
  }
}
