package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Decodes UASTC blocks (UASTC LDR 4x4 Texture Specification). Reused for all blocks of a picture:
 * what it returns is valid until the next block. Mutable.
 */
final class UastcBlock {
  static final int BYTES = 16;

  private static final int TEXELS = TexelBlocks.SIDE * TexelBlocks.SIDE;
  private static final int ALPHA = 3;
  private static final int OPAQUE = 0xff;

  /** Weights of the second end of a range, out of 64, by the number of bits and the weight. */
  private static final int[][] WEIGHTS = {
    {0},
    {0, 64},
    {0, 21, 43, 64},
    {0, 9, 18, 27, 37, 46, 55, 64},
    {0, 4, 8, 12, 17, 21, 25, 29, 35, 39, 43, 47, 52, 56, 60, 64},
    {
      0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 34, 36, 38, 40, 42, 44, 46, 48, 50,
      52, 54, 56, 58, 60, 62, 64
    }
  };

  private final int[] texels = new int[TEXELS];

  /** The ends of color ranges: by subset, channel, and first or second. */
  private final int[] ends = new int[3 * 4 * 2];

  private long low;
  private long high;
  private int at;

  /**
   * Decodes a block.
   *
   * @return texels row by row, with red in the lowest byte and alpha in the highest
   */
  int[] decode(KtxInput in, int offset) throws ImageFormatException {
    ByteBuffer bytes = ByteBuffer.wrap(in.file()).order(ByteOrder.LITTLE_ENDIAN);
    low = bytes.getLong(in.from() + offset);
    high = bytes.getLong(in.from() + offset + Long.BYTES);
    at = 0;
    if (!UastcMode.isKnown((int) low)) {
      throw malformed("KTX is damaged: UASTC block %d has no mode".formatted(offset / BYTES));
    }
    UastcMode mode = UastcMode.of((int) low);
    read(mode.codeBits());
    if (mode == UastcMode.SOLID) {
      Arrays.fill(texels, read(Byte.SIZE) | read(24) << Byte.SIZE);
      return texels;
    }
    at += mode.hintBits();
    byte[] pattern = readPattern(mode, offset);
    int own = mode.channelBits() == 0 ? ALPHA : read(mode.channelBits());
    readEnds(mode);
    readTexels(mode, pattern, own);
    return texels;
  }

  private byte[] readPattern(UastcMode mode, int offset) throws ImageFormatException {
    byte[][] patterns = mode.patterns();
    int number = read(mode.patternBits());
    if (number >= patterns.length) {
      throw malformed(
          "KTX is damaged: UASTC block %d has the pattern %d, expected at most %d"
              .formatted(offset / BYTES, number, patterns.length - 1));
    }
    return patterns[number];
  }

  /** Returns at most 31 bits of the block, the lowest first. */
  private int read(int count) {
    long bits =
        at >= Long.SIZE
            ? high >>> at - Long.SIZE
            : at == 0 ? low : low >>> at | high << Long.SIZE - at;
    at += count;
    return (int) bits & (1 << count) - 1;
  }

  /** Reads the ends of all ranges: first their digits, several in a number, then their bits. */
  private void readEnds(UastcMode mode) {
    Quantization stored = mode.endpoints();
    int count = 2 * mode.channels() * mode.subsets();
    int base = stored.base();
    int group = base == 3 ? 5 : base == 5 ? 3 : count;
    for (int i = 0; i < count; i += group) {
      int members = Math.min(group, count - i);
      int digits = read(digitBits(base, members));
      for (int k = 0; k < members; k++) {
        ends[i + k] = digits % base << stored.bits();
        digits /= base;
      }
    }
    for (int i = 0; i < count; i++) {
      ends[i] = stored.value(ends[i] | read(stored.bits()));
    }
  }

  /** Returns the number of bits of a number of several digits. */
  private static int digitBits(int base, int digits) {
    return switch (base) {
      case 3 -> (8 * digits + 4) / 5;
      case 5 -> (7 * digits + 2) / 3;
      default -> 0;
    };
  }

  /** Reads the weights, and mixes the ends. The first weights of a subset have one bit less. */
  private void readTexels(UastcMode mode, byte[] pattern, int own) {
    int[] weights = WEIGHTS[mode.weightBits()];
    int seen = 0;
    for (int i = 0; i < TEXELS; i++) {
      int subset = pattern[i];
      int bits = mode.weightBits() - ((seen >> subset & 1) == 0 ? 1 : 0);
      seen |= 1 << subset;
      int weight = weights[read(bits)];
      int ownWeight = mode.planes() == 2 ? weights[read(bits)] : weight;
      texels[i] = mixed(mode.channels(), subset, weight, own, ownWeight);
    }
  }

  private int mixed(int channels, int subset, int weight, int own, int ownWeight) {
    int texel = 0;
    for (int channel = 0; channel < 4; channel++) {
      int value = OPAQUE;
      int stored = channels == 2 ? channel / ALPHA : channel;
      if (stored < channels) {
        int first = 2 * (subset * channels + stored);
        value = mix(ends[first], ends[first + 1], channel == own ? ownWeight : weight);
      }
      texel |= value << Byte.SIZE * channel;
    }
    return texel;
  }

  /** Mixes values with 16 bits of precision, and returns the upper 8. */
  private static int mix(int first, int second, int weight) {
    int mixed = first * 0x101 * (64 - weight) + second * 0x101 * weight;
    return mixed + 32 >> 6 + Byte.SIZE;
  }
}
