package io.github.lumbre.image.format.exr;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import java.nio.ByteBuffer;
import java.util.zip.DataFormatException;

/**
 * Unpacks PXR24 compression: floats have lost their last 8 bits, a channel's part of a line is
 * stored as differences, their highest bytes first, then the next ones, and all is deflated
 * ("Technical Introduction to OpenEXR", openexr.com).
 */
final class ExrPxr24 {
  private static final int FLOAT_BYTES = 3;

  private ExrPxr24() {}

  static byte[] unpacked(byte[] packed, ExrBlock block)
      throws ImageFormatException, DataFormatException {
    int pixelBytes = block.channels().stream().mapToInt(ExrPxr24::bytes).sum();
    byte[] split = ExrBytes.inflated(packed, pixelBytes * block.width() * block.height());
    ByteBuffer out = ExrBytes.little(new byte[block.bytes()]);
    int from = 0;
    for (int y = 0; y < block.height(); y++) {
      Interrupts.check();
      for (ExrChannel channel : block.channels()) {
        merge(split, from, channel, block.width(), out);
        from += bytes(channel) * block.width();
      }
    }
    return out.array();
  }

  private static int bytes(ExrChannel channel) {
    return channel.type() == ExrChannel.Type.FLOAT ? FLOAT_BYTES : channel.type().bytes();
  }

  private static void merge(byte[] split, int from, ExrChannel channel, int width, ByteBuffer out) {
    int value = 0;
    for (int x = 0; x < width; x++) {
      int difference = 0;
      for (int i = 0; i < bytes(channel); i++) {
        difference = difference << 8 | split[from + i * width + x] & 0xff;
      }
      value += difference;
      switch (channel.type()) {
        case UINT -> out.putInt(value);
        case HALF -> out.putShort((short) value);
        case FLOAT -> out.putInt(value << 8);
      }
    }
  }
}
