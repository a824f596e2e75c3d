package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LowBits;

/** Reads coded pixels (RFC 9649, sec. 3.6 and 3.7): literals, copies and cached colors. Mutable. */
final class LosslessPixels {
  private static final int MAX_CACHE_BITS = 11;
  private static final int CACHE_FACTOR = 0x1e35a7bd;

  /** A limit for the entries of the tables of all groups, beyond one for each pixel. */
  private static final int MAX_ENTRIES = 1 << 22;

  /** The distances of the first copy codes, as rows above times 16, plus 8, minus columns. */
  private static final int[] NEAR = {
    0x18, 0x07, 0x17, 0x19, 0x28, 0x06, 0x27, 0x29, 0x16, 0x1a, 0x26, 0x2a, 0x38, 0x05, 0x37,
    0x39, 0x15, 0x1b, 0x36, 0x3a, 0x25, 0x2b, 0x48, 0x04, 0x47, 0x49, 0x14, 0x1c, 0x35, 0x3b,
    0x46, 0x4a, 0x24, 0x2c, 0x58, 0x45, 0x4b, 0x34, 0x3c, 0x03, 0x57, 0x59, 0x13, 0x1d, 0x56,
    0x5a, 0x23, 0x2d, 0x44, 0x4c, 0x55, 0x5b, 0x33, 0x3d, 0x68, 0x02, 0x67, 0x69, 0x12, 0x1e,
    0x66, 0x6a, 0x22, 0x2e, 0x54, 0x5c, 0x43, 0x4d, 0x65, 0x6b, 0x32, 0x3e, 0x78, 0x01, 0x77,
    0x79, 0x53, 0x5d, 0x11, 0x1f, 0x64, 0x6c, 0x42, 0x4e, 0x76, 0x7a, 0x21, 0x2f, 0x75, 0x7b,
    0x31, 0x3f, 0x63, 0x6d, 0x52, 0x5e, 0x00, 0x74, 0x7c, 0x41, 0x4f, 0x10, 0x20, 0x62, 0x6e,
    0x30, 0x73, 0x7d, 0x51, 0x5f, 0x40, 0x72, 0x7e, 0x61, 0x6f, 0x50, 0x71, 0x7f, 0x60, 0x70
  };

  private final LowBits bits;
  private final int width;
  private final int height;
  private int[] cache = {};
  private int cacheBits;
  private PrefixCodes[] groups = {};
  private int[] blocks = {0};
  private int blockBits;

  LosslessPixels(LowBits bits, int width, int height) {
    this.bits = bits;
    this.width = width;
    this.height = height;
  }

  /** Returns pixels with a single group of codes. */
  static int[] read(LowBits bits, int width, int height) throws ImageFormatException {
    LosslessPixels reader = new LosslessPixels(bits, width, height);
    reader.readCache();
    reader.readGroups(1, new boolean[] {true});
    int[] pixels = new int[width * height];
    reader.fill(pixels);
    return pixels;
  }

  /** Fills the beginning of an array with pixels whose blocks may have codes of their own. */
  void readWithGroups(int[] pixels) throws ImageFormatException {
    readCache();
    int count = 1;
    if (bits.flag()) {
      blockBits = 2 + bits.read(3);
      blocks =
          read(
              bits,
              LosslessTransform.blocks(width, blockBits),
              LosslessTransform.blocks(height, blockBits));
      for (int i = 0; i < blocks.length; i++) {
        blocks[i] = blocks[i] >> 8 & 0xffff;
        count = Math.max(count, blocks[i] + 1);
      }
    }
    boolean[] used = new boolean[count];
    for (int group : blocks) {
      used[group] = true;
    }
    readGroups(count, used);
    fill(pixels);
  }

  private void readCache() throws ImageFormatException {
    if (bits.flag()) {
      cacheBits = bits.read(4);
      if (cacheBits < 1 || cacheBits > MAX_CACHE_BITS) {
        throw malformed("WebP has a cache of 2^" + cacheBits + " colors, expected 2^1 to 2^11");
      }
      cache = new int[1 << cacheBits];
    }
  }

  private void readGroups(int count, boolean[] used) throws ImageFormatException {
    groups = new PrefixCodes[count];
    long entries = 0;
    for (int i = 0; i < count; i++) {
      Interrupts.check();
      PrefixCodes codes = PrefixCodes.read(bits, cache.length);
      if (used[i]) {
        groups[i] = codes;
        entries += codes.entries();
      }
      if (entries > MAX_ENTRIES + (long) width * height) {
        throw new ImageFormatException(
            ImageFormatException.Kind.TOO_LARGE,
            "WebP has prefix codes that take more memory than its %dx%d pixels"
                .formatted(width, height));
      }
    }
  }

  private void fill(int[] pixels) throws ImageFormatException {
    int end = width * height;
    int x = 0;
    int y = 0;
    for (int i = 0; i < end; ) {
      int length = 1;
      PrefixCodes codes = codes(x, y);
      int symbol = codes.green().read(bits);
      if (symbol < PrefixCodes.LITERALS) {
        pixels[i] = literal(codes, symbol);
      } else if (symbol < PrefixCodes.LITERALS + PrefixCodes.LENGTHS) {
        length = number(symbol - PrefixCodes.LITERALS);
        copy(pixels, i, distance(codes), length, end);
      } else {
        pixels[i] = cache[symbol - PrefixCodes.LITERALS - PrefixCodes.LENGTHS];
      }
      remember(pixels, i, length);
      i += length;
      for (x += length; x >= width; x -= width, y++) {
        Interrupts.check();
      }
    }
  }

  private PrefixCodes codes(int x, int y) {
    if (blocks.length == 1) {
      return groups[blocks[0]];
    }
    int row = (y >> blockBits) * LosslessTransform.blocks(width, blockBits);
    return groups[blocks[row + (x >> blockBits)]];
  }

  private int literal(PrefixCodes codes, int green) throws ImageFormatException {
    int red = codes.red().read(bits);
    int blue = codes.blue().read(bits);
    return codes.alpha().read(bits) << 24 | red << 16 | green << 8 | blue;
  }

  private static void copy(int[] pixels, int to, int distance, int length, int end)
      throws ImageFormatException {
    if (distance > to || length > end - to) {
      throw malformed("WebP is damaged: a copy reaches beyond the picture");
    }
    for (int i = to; i < to + length; i++) {
      pixels[i] = pixels[i - distance];
    }
  }

  private void remember(int[] pixels, int from, int count) {
    for (int i = from; i < from + count && cacheBits > 0; i++) {
      cache[CACHE_FACTOR * pixels[i] >>> Integer.SIZE - cacheBits] = pixels[i];
    }
  }

  /** Returns the number that a symbol and the bits after it stand for: at least 1. */
  private int number(int symbol) throws ImageFormatException {
    if (symbol < 4) {
      return symbol + 1;
    }
    int extra = symbol - 2 >> 1;
    return (2 + (symbol & 1) << extra) + bits.read(extra) + 1;
  }

  private int distance(PrefixCodes codes) throws ImageFormatException {
    int number = number(codes.distance().read(bits));
    if (number > NEAR.length) {
      return number - NEAR.length;
    }
    int near = NEAR[number - 1];
    return Math.max(1, (near >> 4) * width + 8 - (near & 0xf));
  }
}
