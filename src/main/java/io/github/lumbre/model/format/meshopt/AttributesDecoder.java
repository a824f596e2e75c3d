package io.github.lumbre.model.format.meshopt;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Decodes elements from their differences. They are stored block by block, within a block byte by
 * byte of the elements, and of each byte in groups of 16 elements. Mutable.
 */
final class AttributesDecoder {
  private static final int HEADER = 0xa0;
  private static final int BLOCK_BYTES = 8192;
  private static final int BLOCK_ELEMENTS = 256;
  private static final int GROUP = 16;
  private static final int[] MIN_TAIL = {32, 24};

  /** Bits per difference, by the two bits of a group, in version 0 and by control mode. */
  private static final int[] WIDTHS = {0, 2, 4, 8};

  private static final int[][] CONTROLLED_WIDTHS = {{0, 1, 2, 4}, {1, 2, 4, 8}};
  private static final int CONTROL_ZEROS = 2;
  private static final int CONTROL_LITERAL = 3;

  private static final int MODE_BYTES = 0;
  private static final int MODE_SHORTS = 1;
  private static final int MODE_XOR = 2;

  private final MeshoptInput input;
  private final ByteBuffer target;
  private final int stride;
  private final int version;

  /** The index of the element before the first; the modes of channels follow. */
  private final int baseline;

  /** The last element, in channels of four bytes. */
  private final int[] element;

  /** The differences of a block, all of the first byte before all of the second. */
  private final byte[] differences = new byte[BLOCK_BYTES];

  private AttributesDecoder(MeshoptInput input, ByteBuffer target, int stride, int version)
      throws ModelFormatException {
    this.input = input;
    this.target = target;
    this.stride = stride;
    this.version = version;
    element = new int[stride / Integer.BYTES];
    int size = stride + version * element.length;
    int tail = input.reserveTail(Math.max(size, MIN_TAIL[version]));
    baseline = tail + Math.max(0, MIN_TAIL[version] - size);
    for (int i = 0; i < stride; i++) {
      element[i / Integer.BYTES] |= input.unsignedByte(baseline + i) << 8 * (i % Integer.BYTES);
    }
  }

  /** Fills a buffer with elements. */
  static void decode(MeshoptInput input, ByteBuffer target, int stride)
      throws ModelFormatException {
    int version = input.unsignedByte() - HEADER;
    if (version < 0 || version >= MIN_TAIL.length) {
      throw input.unsupported(
          "expected 0xa0 or 0xa1 (version 0 or 1) at byte 0, found 0x%02x"
              .formatted(HEADER + version));
    }
    new AttributesDecoder(input, target, stride, version).decode();
  }

  private void decode() throws ModelFormatException {
    int count = target.limit() / stride;
    int most = Math.min(BLOCK_BYTES / stride & -GROUP, BLOCK_ELEMENTS);
    for (int first = 0; first < count; first += most) {
      Interrupts.check();
      int size = Math.min(most, count - first);
      readBlock(size);
      for (int channel = 0; channel < element.length; channel++) {
        restore(channel, first, size);
      }
    }
    input.requireEnd();
    target.position(target.limit());
  }

  private void readBlock(int size) throws ModelFormatException {
    int controls = input.skip(version * element.length);
    int room = size + GROUP - 1 & -GROUP;
    for (int i = 0; i < stride; i++) {
      if (version == 0) {
        readGroups(WIDTHS, i * room, room);
        continue;
      }
      int control = input.unsignedByte(controls + i / 4) >> 2 * (i % 4) & 3;
      switch (control) {
        case CONTROL_ZEROS -> Arrays.fill(differences, i * room, (i + 1) * room, (byte) 0);
        case CONTROL_LITERAL -> readLiteral(i * room, size);
        default -> readGroups(CONTROLLED_WIDTHS[control], i * room, room);
      }
    }
  }

  private void readLiteral(int to, int size) throws ModelFormatException {
    int from = input.skip(size);
    for (int i = 0; i < size; i++) {
      differences[to + i] = (byte) input.unsignedByte(from + i);
    }
  }

  private void readGroups(int[] widths, int to, int room) throws ModelFormatException {
    int groups = room / GROUP;
    int header = input.skip((groups + 3) / 4);
    for (int i = 0; i < groups; i++) {
      int width = widths[input.unsignedByte(header + i / 4) >> 2 * (i % 4) & 3];
      readGroup(width, to + GROUP * i);
    }
  }

  private void readGroup(int width, int to) throws ModelFormatException {
    int from = input.skip(GROUP * width / 8);
    if (width == 0) {
      Arrays.fill(differences, to, to + GROUP, (byte) 0);
      return;
    }
    int mask = (1 << width) - 1;
    for (int i = 0; i < GROUP; i++) {
      int bit = i * width % 8;
      // Only single bits begin at the lowest.
      int shift = width == 1 ? bit : 8 - width - bit;
      int value = input.unsignedByte(from + i * width / 8) >> shift & mask;
      boolean isEscaped = value == mask && width < 8;
      differences[to + i] = (byte) (isEscaped ? input.unsignedByte() : value);
    }
  }

  /** Adds the differences of four bytes of each element. */
  private void restore(int channel, int first, int size) throws ModelFormatException {
    int mode = version == 0 ? MODE_BYTES : input.unsignedByte(baseline + stride + channel);
    int rotation = mode >> 4;
    if ((mode & 0xf) > MODE_XOR || rotation > 0 && (mode & 0xf) != MODE_XOR) {
      throw input.malformed("expected channel mode 0, 1 or 2, found 0x%02x".formatted(mode));
    }
    int room = size + GROUP - 1 & -GROUP;
    int from = channel * Integer.BYTES * room;
    int to = first * stride + channel * Integer.BYTES;
    int value = element[channel];
    for (int i = 0; i < size; i++) {
      int difference = difference(from + i, room);
      value =
          switch (mode) {
            case MODE_BYTES -> sum(value, difference, 0x01010101, 8);
            case MODE_SHORTS -> sum(value, difference, 0x00010001, 16);
            default -> value ^ Integer.rotateRight(difference, rotation);
          };
      target.putInt(to + i * stride, value);
    }
    element[channel] = value;
  }

  private int difference(int at, int room) {
    return differences[at] & 0xff
        | (differences[at + room] & 0xff) << 8
        | (differences[at + 2 * room] & 0xff) << 16
        | (differences[at + 3 * room] & 0xff) << 24;
  }

  /**
   * Adds numbers that are packed into an integer, each without a carry into the next.
   *
   * @param differences as 0, -1, 1, -2, and so on are numbered
   * @param ones the lowest bit of each number
   * @param width bits per number
   */
  private static int sum(int values, int differences, int ones, int width) {
    int signs = ones << width - 1;
    int negative = (differences & ones) * ((1 << width) - 1);
    int signed = differences >>> 1 & ~signs ^ negative;
    return (values & ~signs) + (signed & ~signs) ^ (values ^ signed) & signs;
  }
}
