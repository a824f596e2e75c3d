package io.github.lumbre.image.format.dds;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Decodes blocks of BC7 (Khronos Data Format Specification 1.3, chapter 20). Mutable; reused for
 * all blocks of a picture.
 */
final class Bc7Block {
  /** Two bits for each pixel, the first one lowest: its subset, of two, in 64 partitions. */
  private static final String TWO =
      "cccc8888eeeeecc8c880feecfec8ec80c800ffecfe80e800ffe8ff00fff0f000f710008e710008ce"
          + "008c731031008cce088c31106666366c17e80ff0718e399caaaaf0f05a5a33cc3c3c55aa9696a55a"
          + "73ce13c8324c3bdc6996c33c99660660027204e44e402720c936936c39c6639c93369cc6817ee718"
          + "ccf00fcc7744ee22";

  /** As {@link #TWO}, with two bits for each pixel: its subset, of three. */
  private static final String THREE =
      "aa6850506a5a50405a5a42005450a0a8a5a50000a0a050505555a0a05a5a5050aa550000aa555500"
          + "aaaa55009090909094949494a4a4a4a4a9a594502a0a4250a59450400a425054a5a5a50055a0a0a0"
          + "a8a854546a6a4040a4a450001a1a05000050a4a4aaa590901469691469691400a08585a0aa821414"
          + "50a4a4506a5a0200a9a580005090a0a8a8a090502424242400aa5500249249242449922450a50a50"
          + "500aa550aaaa444466660000a5a0a5a050a050a06928692844aaaa4466666600aa44444454a854a8"
          + "9580958096969600a85454a880959580aa14141496960000aaaa1414a05050a0a0a5a5a096000000"
          + "40804080a9a8a9a8aaaaaa442a4a5254";

  /** The pixel of the second subset whose index has one bit less, in partitions of two. */
  private static final String TWO_ANCHOR =
      "fffffffffffffffff282288f28228822ff6828ff28222ff66268ff22fffff22f";

  /** The pixels of the second and of the third subset, in partitions of three. */
  private static final String[] THREE_ANCHORS = {
    "33ff83ff88666533338f336a588685ff8f356a8ff3f5ffff3f55585a5a8dfc33",
    "f883ff38fffffff8f8f3f8f83f6affa8f3faa89a6f8f3668f3ffffffffff3ff8"
  };

  private static final int[][] WEIGHTS = {
    {},
    {},
    {0, 21, 43, 64},
    {0, 9, 18, 27, 37, 46, 55, 64},
    {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64}
  };

  /**
   * The layout of a block.
   *
   * @param ownBits low bits of end points: 0 none, 1 one for each, 2 one for both of a subset
   */
  private record Mode(
      int subsets,
      int partitionBits,
      int rotationBits,
      int swapBits,
      int colorBits,
      int alphaBits,
      int ownBits,
      int indexBits,
      int otherBits) {}

  private static final Mode[] MODES = {
    new Mode(3, 4, 0, 0, 4, 0, 1, 3, 0),
    new Mode(2, 6, 0, 0, 6, 0, 2, 3, 0),
    new Mode(3, 6, 0, 0, 5, 0, 0, 2, 0),
    new Mode(2, 6, 0, 0, 7, 0, 1, 2, 0),
    new Mode(1, 0, 2, 1, 5, 6, 0, 2, 3),
    new Mode(1, 0, 2, 0, 7, 8, 0, 2, 2),
    new Mode(1, 0, 0, 0, 7, 7, 1, 4, 0),
    new Mode(2, 6, 0, 0, 5, 5, 1, 2, 0)
  };

  private final int[][] ends = new int[6][4];
  private long low;
  private long high;

  /**
   * Decodes a block.
   *
   * @param out receives red, green, blue and alpha of 16 pixels; all are 0 for the reserved mode
   */
  void decode(ByteBuffer file, int at, byte[] out) {
    low = file.getLong(at);
    high = file.getLong(at + Long.BYTES);
    int number = Long.numberOfTrailingZeros(low & 0xff);
    if (number >= MODES.length) {
      Arrays.fill(out, (byte) 0);
      return;
    }
    take(number + 1);
    Mode mode = MODES[number];
    int partition = take(mode.partitionBits);
    int rotation = take(mode.rotationBits);
    boolean isSwapped = take(mode.swapBits) == 1;
    readEnds(mode);
    int[] first = indices(mode, mode.indexBits, partition);
    int[] second = mode.otherBits == 0 ? first : indices(mode, mode.otherBits, partition);
    int[] firstWeights = WEIGHTS[mode.indexBits];
    int[] secondWeights = mode.otherBits == 0 ? firstWeights : WEIGHTS[mode.otherBits];
    for (int pixel = 0; pixel < 16; pixel++) {
      int subset = subset(mode, partition, pixel);
      int one = firstWeights[first[pixel]];
      int other = secondWeights[second[pixel]];
      for (int channel = 0; channel < 4; channel++) {
        int weight = channel == 3 == isSwapped ? one : other;
        int value =
            (64 - weight) * ends[2 * subset][channel] + weight * ends[2 * subset + 1][channel];
        int to = channel == 3 && rotation > 0 ? rotation - 1 : channel;
        to = channel == rotation - 1 ? 3 : to;
        out[4 * pixel + to] = (byte) (value + 32 >> 6);
      }
    }
  }

  /** Returns the next bits of the block. */
  private int take(int count) {
    int bits = (int) (low & (1L << count) - 1);
    if (count > 0) {
      low = low >>> count | high << Long.SIZE - count;
      high >>>= count;
    }
    return bits;
  }

  private void readEnds(Mode mode) {
    int count = 2 * mode.subsets;
    for (int channel = 0; channel < 4; channel++) {
      for (int end = 0; end < count; end++) {
        ends[end][channel] = take(channel < 3 ? mode.colorBits : mode.alphaBits);
      }
    }
    int own = 0;
    for (int end = 0; end < count; end++) {
      own = mode.ownBits == 1 || mode.ownBits == 2 && end % 2 == 0 ? take(1) : own;
      for (int channel = 0; channel < 4; channel++) {
        int bits = channel < 3 ? mode.colorBits : mode.alphaBits;
        int value = ends[end][channel];
        if (mode.ownBits > 0) {
          value = value << 1 | own;
          bits++;
        }
        value <<= 8 - bits;
        ends[end][channel] = mode.alphaBits == 0 && channel == 3 ? 255 : value | value >> bits;
      }
    }
  }

  private int[] indices(Mode mode, int bits, int partition) {
    int[] indices = new int[16];
    for (int pixel = 0; pixel < 16; pixel++) {
      indices[pixel] = take(isAnchor(mode, partition, pixel) ? bits - 1 : bits);
    }
    return indices;
  }

  private static boolean isAnchor(Mode mode, int partition, int pixel) {
    return pixel == 0
        || mode.subsets == 2 && digit(TWO_ANCHOR, partition) == pixel
        || mode.subsets == 3
            && (digit(THREE_ANCHORS[0], partition) == pixel
                || digit(THREE_ANCHORS[1], partition) == pixel);
  }

  private static int subset(Mode mode, int partition, int pixel) {
    return switch (mode.subsets) {
      case 1 -> 0;
      case 2 -> digit(TWO, 4 * partition + 3 - pixel / 4) >> pixel % 4 & 1;
      default -> digit(THREE, 8 * partition + 7 - pixel / 2) >> 2 * (pixel % 2) & 3;
    };
  }

  private static int digit(String digits, int index) {
    return Character.digit(digits.charAt(index), 16);
  }
}
