package io.github.lumbre.image.format.dds;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Decodes the largest level of a DDS file with one picture. Mutable; one for each file. */
public final class DdsFile {
  private static final int MAGIC = 0x20534444;
  private static final int HEADER = 128;
  private static final int EXTENDED_HEADER = 148;
  private static final int CUBE = 0x200;
  private static final int VOLUME = 0x200000;
  private static final int EXTENDED_CUBE = 4;
  private static final int FLAT = 3;

  private final ByteBuffer file;
  private final DdsFormat format;
  private final int width;
  private final int height;
  private final byte[] values;
  private final byte[] texels = new byte[64];
  private final Bc7Block bc7 = new Bc7Block();

  private DdsFile(ByteBuffer file, DdsFormat format, int width, int height) {
    this.file = file;
    this.format = format;
    this.width = width;
    this.height = height;
    values = new byte[Math.multiplyExact(format.channels(), width * height)];
  }

  public static boolean startsIn(byte[] file) {
    return file.length >= Integer.BYTES && buffer(file).getInt(0) == MAGIC;
  }

  private static ByteBuffer buffer(byte[] file) {
    return ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * Reads the header of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if it is truncated, not of a supported kind, or exceeds the limits
   */
  public static EncodedPicture open(byte[] bytes) throws ImageFormatException {
    ByteBuffer file = buffer(bytes);
    boolean isExtended = bytes.length >= HEADER && DdsFormat.isExtended(file);
    int start = isExtended ? EXTENDED_HEADER : HEADER;
    if (bytes.length < start) {
      throw malformed("DDS is truncated");
    }
    int height = file.getInt(12);
    int width = file.getInt(16);
    int kind = file.getInt(112);
    boolean isCube = (kind & CUBE) != 0 || isExtended && (file.getInt(136) & EXTENDED_CUBE) != 0;
    boolean isArray = isExtended && file.getInt(140) > 1;
    boolean isFlat = (kind & VOLUME) == 0 && (!isExtended || file.getInt(132) == FLAT);
    if (isCube || isArray || !isFlat) {
      String found = isCube ? "a cube map" : isArray ? "an array" : "a volume or a line";
      throw malformed("DDS has " + found + " of pictures, expected one picture");
    }
    PictureLimits.checkSize(width, height);
    DdsFormat format = DdsFormat.of(file);
    long rows = format.block() == 0 ? height : (height + 3) / 4;
    if (rows * format.rowBytes(width) > bytes.length - start) {
      throw malformed("DDS data are too short for " + width + "x" + height + " pixels");
    }
    ByteBuffer data = buffer(bytes).position(start).slice().order(ByteOrder.LITTLE_ENDIAN);
    return new EncodedPicture(
        width, height, format.channels(), () -> new DdsFile(data, format, width, height).decode());
  }

  private Pixels decode() {
    int step = format.block() == 0 ? 1 : 4;
    int at = 0;
    for (int y = 0; y < height; y += step) {
      Interrupts.check();
      for (int x = 0; x < width; x += step, at += format.bytes()) {
        if (step == 1) {
          putPixel(at, (y * width + x) * format.channels());
        } else {
          decodeBlock(at);
          putBlock(x, y);
        }
      }
    }
    return Pixels.of(width, height, format.channels(), values);
  }

  private void putPixel(int at, int to) {
    int pixel = 0;
    for (int i = 0; i < format.bytes(); i++) {
      pixel |= (file.get(at + i) & 0xff) << 8 * i;
    }
    for (int channel = 0; channel < format.channels(); channel++) {
      int mask = format.masks()[channel];
      int shift = Integer.numberOfTrailingZeros(mask);
      long max = mask == 0 ? 1 : (mask >>> shift) & 0xffffffffL;
      long value = mask == 0 ? 0 : (pixel & mask) >>> shift;
      values[to + channel] = (byte) ((value * 255 + max / 2) / max);
    }
  }

  private void decodeBlock(int at) {
    switch (format.block()) {
      case 1 -> DdsBlocks.colors(file, at, true, texels);
      case 2 -> {
        DdsBlocks.colors(file, at + 8, false, texels);
        DdsBlocks.alpha(file, at, texels);
      }
      case 3 -> {
        DdsBlocks.colors(file, at + 8, false, texels);
        DdsBlocks.channel(file, at, texels, 3, 4);
      }
      case 4 -> DdsBlocks.channel(file, at, texels, 0, 1);
      case 5 -> {
        DdsBlocks.channel(file, at, texels, 0, 3);
        DdsBlocks.channel(file, at + 8, texels, 1, 3);
        DdsBlocks.addBlue(texels);
      }
      default -> bc7.decode(file, at, texels);
    }
  }

  /** Writes the part of a block that lies in the picture. */
  private void putBlock(int x, int y) {
    int channels = format.channels();
    int length = channels * Math.min(4, width - x);
    for (int row = 0; row < Math.min(4, height - y); row++) {
      int to = ((y + row) * width + x) * channels;
      System.arraycopy(texels, 4 * channels * row, values, to, length);
    }
  }
}
