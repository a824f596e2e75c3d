package io.github.lumbre.image.format.dds;

import java.nio.ByteBuffer;

/**
 * Decodes blocks of 4×4 pixels of BC1 to BC5 (Khronos Data Format Specification 1.3, chapters 18
 * and 19). Values between two end points are rounded. Stateless.
 */
final class DdsBlocks {
  private static final int PIXELS = 16;

  private DdsBlocks() {}

  /**
   * Decodes the colors of a block of 8 bytes, and alpha if it is BC1.
   *
   * @param isBc1 whether the order of the two colors decides that a fourth one is transparent black
   * @param out receives red, green, blue and, of BC1, alpha of 16 pixels with four channels
   */
  static void colors(ByteBuffer file, int at, boolean isBc1, byte[] out) {
    int first = file.getShort(at) & 0xffff;
    int second = file.getShort(at + 2) & 0xffff;
    boolean isClear = isBc1 && first <= second;
    int choices = file.getInt(at + 4);
    for (int pixel = 0; pixel < PIXELS; pixel++) {
      int choice = choices >> 2 * pixel & 3;
      for (int channel = 0; channel < 3; channel++) {
        int a = channel(first, channel);
        int b = channel(second, channel);
        out[4 * pixel + channel] =
            (byte)
                switch (choice) {
                  case 0 -> a;
                  case 1 -> b;
                  case 2 -> isClear ? (a + b + 1) / 2 : (2 * a + b + 1) / 3;
                  default -> isClear ? 0 : (a + 2 * b + 1) / 3;
                };
      }
      if (isBc1) {
        out[4 * pixel + 3] = (byte) (isClear && choice == 3 ? 0 : 255);
      }
    }
  }

  /** Returns red, green or blue, 0 to 255, of a color of 5, 6 and 5 bits. */
  private static int channel(int color, int channel) {
    int six = color >> 5 & 0x3f;
    int five = (channel == 0 ? color >> 11 : color) & 0x1f;
    return channel == 1 ? six << 2 | six >> 4 : five << 3 | five >> 2;
  }

  /** Decodes the alpha of BC2: 4 bits for each pixel. */
  static void alpha(ByteBuffer file, int at, byte[] out) {
    long bits = file.getLong(at);
    for (int pixel = 0; pixel < PIXELS; pixel++) {
      out[4 * pixel + 3] = (byte) ((bits >> 4 * pixel & 15) * 17);
    }
  }

  /**
   * Decodes one channel of BC3, BC4 or BC5: two values, and those between them.
   *
   * @param to place of the channel in a pixel of {@code out}
   * @param channels of a pixel
   */
  static void channel(ByteBuffer file, int at, byte[] out, int to, int channels) {
    int first = file.get(at) & 0xff;
    int second = file.get(at + 1) & 0xff;
    long choices = file.getLong(at) >>> 16;
    int steps = first > second ? 7 : 5;
    for (int pixel = 0; pixel < PIXELS; pixel++) {
      int choice = (int) (choices >> 3 * pixel) & 7;
      int weight = choice < 2 ? choice * steps : choice - 1;
      int between = ((steps - weight) * first + weight * second + steps / 2) / steps;
      boolean isLimit = steps == 5 && choice > 5;
      int limit = choice == 6 ? 0 : 255;
      out[channels * pixel + to] = (byte) (isLimit ? limit : between);
    }
  }

  /**
   * Adds the third component of the unit normals whose other two are in 16 pixels of three
   * channels; BC5 stores normal maps so.
   */
  static void addBlue(byte[] out) {
    for (int i = 0; i < 3 * PIXELS; i += 3) {
      double x = (out[i] & 0xff) / 127.5 - 1;
      double y = (out[i + 1] & 0xff) / 127.5 - 1;
      double z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
      out[i + 2] = (byte) Math.round(127.5 + 127.5 * z);
    }
  }
}
