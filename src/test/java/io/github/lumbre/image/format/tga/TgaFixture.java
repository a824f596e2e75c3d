package io.github.lumbre.image.format.tga;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;

/**
 * Writes TGA files. Its pixels are given as they are stored, row by row in the file's order.
 *
 * @param type 1, 2, 3, 9, 10 or 11
 * @param depth bits per pixel
 * @param descriptor bits of alpha, order of rows and columns
 * @param colorDepth bits per color of the palette, 0 without one
 * @param palette bytes of the palette
 */
public record TgaFixture(int type, int depth, int descriptor, int colorDepth, byte... palette) {
  static final int FIRST = 3;

  /** Returns a file with a name of three bytes before its palette. */
  byte[] file(int width, int height, byte[] pixels) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    int colors = colorDepth == 0 ? 0 : palette.length / ((colorDepth + 7) / 8);
    int[] head = {3, colors > 0 ? 1 : 0, type, colors > 0 ? FIRST : 0, 0, colors, 0, colorDepth};
    int[] size = {width, width >> 8, height, height >> 8, depth, descriptor, 'a', 'b', 'c'};
    Arrays.stream(head).forEach(out::write);
    out.writeBytes(new byte[4]);
    Arrays.stream(size).forEach(out::write);
    out.writeBytes(palette);
    out.writeBytes(type > 8 ? packed(pixels) : pixels);
    return out.toByteArray();
  }

  /** Packs pixels: equal ones as runs, others alone, in packets that do not end with the rows. */
  private byte[] packed(byte[] pixels) {
    int size = (depth + 7) / 8;
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    int count = pixels.length / size;
    for (int i = 0; i < count; ) {
      int run = 1;
      while (i + run < count
          && run < 128
          && Arrays.equals(
              pixels, i * size, (i + 1) * size, pixels, (i + run) * size, (i + run + 1) * size)) {
        run++;
      }
      int length = run > 1 ? run : Math.min(3, count - i);
      out.write(run > 1 ? 0x80 | run - 1 : length - 1);
      out.write(pixels, i * size, (run > 1 ? 1 : length) * size);
      i += length;
    }
    return out.toByteArray();
  }

  static byte[] withFooter(byte[] file) {
    byte[] footer = "\0\0\0\0\0\0\0\0TRUEVISION-XFILE.\0".getBytes(StandardCharsets.US_ASCII);
    byte[] whole = Arrays.copyOf(file, file.length + footer.length);
    System.arraycopy(footer, 0, whole, file.length, footer.length);
    return whole;
  }

  /** Returns files of all kinds, for mutation. */
  public static Stream<byte[]> files() {
    byte[] palette = new byte[12];
    new Random(1).nextBytes(palette);
    return Stream.of(1, 9)
        .flatMap(
            packed ->
                Stream.of(
                        new TgaFixture(packed, 8, 0, 24, palette),
                        new TgaFixture(packed, 16, 8, 32, palette),
                        new TgaFixture(packed + 1, 15, 0x20, 0),
                        new TgaFixture(packed + 1, 16, 1, 0),
                        new TgaFixture(packed + 1, 24, 0x10, 0),
                        new TgaFixture(packed + 1, 32, 0x38, 0),
                        new TgaFixture(packed + 2, 8, 0, 0),
                        new TgaFixture(packed + 2, 16, 8, 0))
                    .map(TgaFixture::sample))
        .flatMap(file -> List.of(file, withFooter(file)).stream());
  }

  private byte[] sample() {
    int size = (depth + 7) / 8;
    byte[] pixels = new byte[7 * 5 * size];
    Random random = new Random(depth);
    for (int i = 0; i < pixels.length; i += size) {
      boolean isSame = i > 0 && random.nextBoolean();
      for (int b = 0; b < size; b++) {
        int color = b == 0 ? FIRST + random.nextInt(Math.max(1, palette.length / 4)) : 0;
        int value = palette.length > 0 ? color : random.nextInt(256);
        pixels[i + b] = isSame ? pixels[i - size + b] : (byte) value;
      }
    }
    return file(7, 5, pixels);
  }
}
