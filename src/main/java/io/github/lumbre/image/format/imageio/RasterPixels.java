package io.github.lumbre.image.format.imageio;

import io.github.lumbre.image.Pixels;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentSampleModel;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferUShort;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.util.Objects;

/**
 * Takes the stored values out of pictures that Java has decoded, without conversion between color
 * spaces.
 */
final class RasterPixels {
  private static final int BYTE = 0xff;
  private static final int WORD = 0xffff;

  private RasterPixels() {}

  /**
   * Returns the values of a picture of gray or RGB, with or without alpha, or of a palette. Values
   * of less than 8 bits are scaled to 8 bits, and of 9 to 15 bits to 16 bits. Bands beyond color
   * and alpha are left out.
   */
  static Pixels of(BufferedImage picture) {
    Raster raster = picture.getRaster();
    if (picture.getColorModel() instanceof IndexColorModel palette) {
      return looked(raster, palette);
    }
    int bands =
        picture.getColorModel().hasAlpha()
            ? raster.getNumBands()
            : picture.getColorModel().getNumColorComponents();
    return bands == raster.getNumBands()
            && raster.getSampleModel() instanceof ComponentSampleModel model
        ? stored(raster, model)
        : scaled(raster, bands);
  }

  /** Returns the values of a picture without its palette and without the bands beyond color. */
  static Pixels withoutAlpha(BufferedImage picture) {
    return scaled(picture.getRaster(), picture.getColorModel().getNumColorComponents());
  }

  /** Returns the values of a picture, in its own array if possible. */
  private static Pixels stored(Raster raster, ComponentSampleModel model) {
    int bands = model.getNumBands();
    long size = (long) bands * raster.getWidth() * raster.getHeight();
    boolean isDense = model.getPixelStride() == bands && raster.getDataBuffer().getNumBanks() == 1;
    if (isDense && raster.getDataBuffer() instanceof DataBufferByte buffer) {
      byte[] values = buffer.getData();
      if (values.length == size && model.getSampleSize(0) == Byte.SIZE) {
        order(values, model.getBandOffsets());
        return Pixels.of(raster.getWidth(), raster.getHeight(), bands, values);
      }
    }
    if (isDense && raster.getDataBuffer() instanceof DataBufferUShort buffer) {
      short[] values = buffer.getData();
      if (values.length == size && isNatural(model.getBandOffsets())) {
        return Pixels.of(raster.getWidth(), raster.getHeight(), bands, values);
      }
    }
    return scaled(raster, bands);
  }

  private static boolean isNatural(int[] offsets) {
    for (int i = 0; i < offsets.length; i++) {
      if (offsets[i] != i) {
        return false;
      }
    }
    return true;
  }

  /** Brings the channels of all pixels into the order red, green, blue, alpha. */
  private static void order(byte[] values, int[] offsets) {
    if (isNatural(offsets)) {
      return;
    }
    byte[] pixel = new byte[offsets.length];
    for (int i = 0; i < values.length; i += pixel.length) {
      System.arraycopy(values, i, pixel, 0, pixel.length);
      for (int band = 0; band < pixel.length; band++) {
        values[i + band] = pixel[offsets[band]];
      }
    }
  }

  /**
   * Returns the values of a picture as 8 or 16 bits.
   *
   * @param channels the number of bands that are color or alpha
   */
  private static Pixels scaled(Raster raster, int channels) {
    int width = raster.getWidth();
    int bands = raster.getNumBands();
    boolean isWide = raster.getSampleModel().getSampleSize(0) > Byte.SIZE;
    int size = Math.multiplyExact(channels, width * raster.getHeight());
    byte[] bytes = new byte[isWide ? 0 : size];
    short[] shorts = new short[isWide ? size : 0];
    int most = isWide ? WORD : BYTE;
    int[] row = new int[bands * width];
    int to = 0;
    for (int y = 0; y < raster.getHeight(); y++) {
      raster.getPixels(0, y, width, 1, row);
      for (int x = 0; x < width; x++) {
        for (int c = 0; c < channels; c++, to++) {
          int value = scaled(raster, c, row[bands * x + c], most);
          if (isWide) {
            shorts[to] = (short) value;
          } else {
            bytes[to] = (byte) value;
          }
        }
      }
    }
    return isWide
        ? Pixels.of(width, raster.getHeight(), channels, shorts)
        : Pixels.of(width, raster.getHeight(), channels, bytes);
  }

  private static int scaled(Raster raster, int band, int sample, int most) {
    int max = (1 << raster.getSampleModel().getSampleSize(band)) - 1;
    return max == most ? sample : (sample * most + max / 2) / max;
  }

  private static Pixels looked(Raster raster, IndexColorModel palette) {
    int width = raster.getWidth();
    int channels = palette.hasAlpha() ? 4 : 3;
    byte[] rgb = new byte[Math.multiplyExact(channels, width * raster.getHeight())];
    int[] row = new int[width];
    int i = 0;
    for (int y = 0; y < raster.getHeight(); y++) {
      raster.getSamples(0, y, width, 1, 0, row);
      for (int index : row) {
        Objects.checkIndex(index, palette.getMapSize());
        rgb[i++] = (byte) palette.getRed(index);
        rgb[i++] = (byte) palette.getGreen(index);
        rgb[i++] = (byte) palette.getBlue(index);
        if (channels == 4) {
          rgb[i++] = (byte) palette.getAlpha(index);
        }
      }
    }
    return Pixels.of(width, raster.getHeight(), channels, rgb);
  }
}
