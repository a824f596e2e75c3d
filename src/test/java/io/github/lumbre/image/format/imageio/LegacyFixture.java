package io.github.lumbre.image.format.imageio;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Random;
import java.util.stream.Stream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes BMP, GIF and TIFF files with Java. */
public final class LegacyFixture {
  static final int WIDTH = 21;
  static final int HEIGHT = 9;

  private LegacyFixture() {}

  /** Returns a picture of stripes and noise. */
  static BufferedImage picture(int type) {
    Random random = new Random(type);
    BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, type);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      int color = i % WIDTH < 12 ? 0xff336699 : random.nextInt();
      picture.setRGB(i % WIDTH, i / WIDTH, color);
    }
    return picture;
  }

  /**
   * Returns a file.
   *
   * @param type of the picture, of {@link BufferedImage}
   * @param compression as Java names it; empty for the usual one
   */
  static byte[] file(String format, int type, String compression) {
    ImageWriter writer = ImageIO.getImageWritersByFormatName(format).next();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      ImageWriteParam param = writer.getDefaultWriteParam();
      if (!compression.isEmpty()) {
        param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        param.setCompressionType(compression);
      }
      writer.write(null, new IIOImage(picture(type), null, null), param);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      writer.dispose();
    }
    return out.toByteArray();
  }

  /** Returns a file of two pictures. */
  public static byte[] two(String format) {
    ImageWriter writer = ImageIO.getImageWritersByFormatName(format).next();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.prepareWriteSequence(null);
      for (int i = 0; i < 2; i++) {
        writer.writeToSequence(
            new IIOImage(picture(BufferedImage.TYPE_BYTE_INDEXED), null, null), null);
      }
      writer.endWriteSequence();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      writer.dispose();
    }
    return out.toByteArray();
  }

  public static Stream<byte[]> bmps() {
    return Stream.concat(
        Stream.of(
                BufferedImage.TYPE_3BYTE_BGR,
                BufferedImage.TYPE_USHORT_565_RGB,
                BufferedImage.TYPE_BYTE_INDEXED,
                BufferedImage.TYPE_BYTE_BINARY)
            .map(type -> file("bmp", type, "")),
        Stream.of(file("bmp", BufferedImage.TYPE_BYTE_INDEXED, "BI_RLE8")));
  }

  public static Stream<byte[]> gifs() {
    return Stream.of(
            BufferedImage.TYPE_BYTE_INDEXED,
            BufferedImage.TYPE_BYTE_BINARY,
            BufferedImage.TYPE_INT_ARGB)
        .map(type -> file("gif", type, ""));
  }

  public static Stream<byte[]> tiffs() {
    return Stream.of("LZW", "Deflate", "PackBits", "")
        .flatMap(
            compression ->
                Stream.of(
                        BufferedImage.TYPE_3BYTE_BGR,
                        BufferedImage.TYPE_4BYTE_ABGR,
                        BufferedImage.TYPE_BYTE_GRAY,
                        BufferedImage.TYPE_USHORT_GRAY,
                        BufferedImage.TYPE_BYTE_INDEXED,
                        BufferedImage.TYPE_BYTE_BINARY)
                    .map(type -> file("tiff", type, compression)));
  }

  /** Returns a copy of a TIFF file whose field has another value. */
  public static byte[] with(byte[] tiff, int tag, int value) {
    ByteBuffer copy = ByteBuffer.wrap(tiff.clone());
    copy.order(tiff[0] == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    int start = copy.getInt(4);
    for (int i = 0; i < copy.getShort(start); i++) {
      int at = start + 2 + 12 * i;
      if (copy.getShort(at) == (short) tag) {
        copy.putShort(at + 2, (short) 4).putInt(at + 4, 1).putInt(at + 8, value);
        return copy.array();
      }
    }
    throw new IllegalArgumentException("no field " + tag);
  }
}
