package io.github.lumbre.image.format.imageio;

import static io.github.lumbre.image.ImageFormatException.Kind.MALFORMED;
import static io.github.lumbre.image.ImageFormatException.Kind.TOO_LARGE;
import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedFormat;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of BMP, GIF and TIFF files, and what is refused before Java sees it. */
class LegacyPicturesTest {
  private static final int RGB = BufferedImage.TYPE_3BYTE_BGR;
  private static final int RGBA = BufferedImage.TYPE_4BYTE_ABGR;
  private static final int GRAY = BufferedImage.TYPE_BYTE_GRAY;
  private static final int GRAY_16 = BufferedImage.TYPE_USHORT_GRAY;
  private static final int PALETTE = BufferedImage.TYPE_BYTE_INDEXED;
  private static final int BILEVEL = BufferedImage.TYPE_BYTE_BINARY;

  private static void assertRefused(
      byte[] file, Limits limits, ImageFormatException.Kind kind, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file, limits))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(kind))
        .hasMessageStartingWith(message);
  }

  private static void assertRefused(byte[] file, String message) {
    assertRefused(file, Limits.NONE, MALFORMED, message);
  }

  private static ByteBuffer little(byte[] file) {
    return ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static void assertSame(Pixels pixels, BufferedImage picture) {
    boolean isGray =
        picture.getRaster().getNumBands() == 1 && pixels.max() > 255 || picture.getType() == GRAY;
    assertThat(pixels.hasAlpha()).isEqualTo(picture.getColorModel().hasAlpha());
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = 0; x < picture.getWidth(); x++) {
        int rgb = picture.getRGB(x, y);
        for (int channel = 0; channel < 3; channel++) {
          int expected =
              isGray ? picture.getRaster().getSample(x, y, 0) : rgb >> 16 - 8 * channel & 0xff;
          assertThat(pixels.raw(x, y, channel)).isEqualTo(expected);
        }
        assertThat(pixels.alpha(x, y)).isEqualTo(pixels.hasAlpha() ? rgb >>> 24 : pixels.max());
      }
    }
  }

  static Stream<Object[]> kinds() {
    return Stream.concat(
        Stream.of(
            new Object[] {"bmp", RGB, ""},
            new Object[] {"bmp", BufferedImage.TYPE_USHORT_565_RGB, ""},
            new Object[] {"bmp", PALETTE, ""},
            new Object[] {"bmp", PALETTE, "BI_RLE8"},
            new Object[] {"bmp", BILEVEL, ""},
            new Object[] {"gif", PALETTE, ""},
            new Object[] {"gif", BILEVEL, ""},
            new Object[] {"tiff", BILEVEL, "CCITT T.6"}),
        Stream.of("", "LZW", "Deflate", "ZLib", "PackBits")
            .flatMap(
                packing ->
                    Stream.of(RGB, RGBA, GRAY, GRAY_16, PALETTE, BILEVEL)
                        .map(type -> new Object[] {"tiff", type, packing})));
  }

  @ParameterizedTest
  @org.junit.jupiter.params.provider.MethodSource("kinds")
  void valuesAreThoseOfTheFile(String format, int type, String packing) throws IOException {
    Pixels pixels = ImageReader.decode(LegacyFixture.file(format, type, packing));
    assertSame(pixels, LegacyFixture.picture(type));
  }

  @ParameterizedTest
  @ValueSource(strings = {"gif", "tiff"})
  void furtherPicturesAreFound(String format) throws IOException {
    byte[] two = LegacyFixture.two(format);
    assertSame(ImageReader.decode(two), LegacyFixture.picture(PALETTE));
    assertThat(EncodedFormat.hasMorePictures(two)).isTrue();
    assertThat(EncodedFormat.hasMorePictures(LegacyFixture.file(format, PALETTE, ""))).isFalse();
    int first = 0;
    for (int length = 0; length < two.length; length++) {
      first += EncodedFormat.hasMorePictures(Arrays.copyOf(two, length)) ? 0 : 1;
    }
    assertThat(first).isBetween(1, two.length);
  }

  @ParameterizedTest
  @ValueSource(strings = {"bmp", "gif", "tiff"})
  void uploadsAreRefusedUnlessAllowed(String format) throws IOException {
    byte[] file = LegacyFixture.file(format, PALETTE, "");
    String name = format.toUpperCase(java.util.Locale.ROOT);
    assertRefused(
        file,
        Limits.UPLOADS,
        MALFORMED,
        "found a "
            + name
            + " picture, which these limits refuse; save it as a PNG or JPEG, or call"
            + " Limits.withLegacyPictures(true)");
    Limits allowed = Limits.UPLOADS.withLegacyPictures(true);
    assertThat(ImageReader.decode(file, allowed).width()).isEqualTo(LegacyFixture.WIDTH);
    assertRefused(
        file, allowed.withTexels(100), TOO_LARGE, "the picture has 21x9 pixels, expected at most");
    assertRefused(
        file, allowed.withMemory(100), TOO_LARGE, "the picture has 21x9 pixels: expected at most");
  }

  /** Returns a BMP of two pixels with masks for red, green, blue and alpha (BITMAPV4HEADER). */
  private static byte[] masked(int... pixels) {
    ByteBuffer file = little(new byte[14 + 108 + 8]);
    file.put((byte) 'B').put((byte) 'M').putInt(file.capacity()).putInt(0).putInt(14 + 108);
    file.putInt(108).putInt(2).putInt(1).putShort((short) 1).putShort((short) 32);
    file.putInt(3).putInt(8).putInt(0).putInt(0).putInt(0).putInt(0);
    file.putInt(0xff0000).putInt(0xff00).putInt(0xff).putInt(0xff000000);
    file.position(14 + 108);
    return file.putInt(pixels[0]).putInt(pixels[1]).array();
  }

  @Test
  void anAlphaOfZeroEverywhereIsNone() throws IOException {
    Pixels clear = ImageReader.decode(masked(0x00102030, 0x01405060));
    assertThat(clear.alpha(0, 0)).isZero();
    assertThat(clear.alpha(1, 0)).isEqualTo(1);
    Pixels opaque = ImageReader.decode(masked(0x00102030, 0x00405060));
    assertThat(opaque.hasAlpha()).isFalse();
    assertThat(opaque.raw(1, 0, 0)).isEqualTo(0x40);
    assertThat(opaque.raw(1, 0, 2)).isEqualTo(0x60);
  }

  @Test
  void sizesOfBmpAreCheckedFirst() {
    byte[] file = LegacyFixture.file("bmp", RGB, "");
    assertRefused(
        little(file.clone()).putInt(18, 1 << 20).array(),
        Limits.NONE,
        TOO_LARGE,
        "the picture has 1048576x9 pixels");
    assertRefused(
        little(file.clone()).putInt(22, Integer.MIN_VALUE).array(),
        Limits.NONE,
        TOO_LARGE,
        "the picture has 21x2147483648 pixels");
    assertRefused(
        little(file.clone()).putInt(18, 60000).array(),
        "BMP data are too short for 60000x9 pixels");
    assertRefused(little(file.clone()).putInt(10, -1).array(), "BMP data are too short");
    assertRefused(
        little(LegacyFixture.file("bmp", PALETTE, "BI_RLE8"))
            .putInt(18, 65535)
            .putInt(22, 4000)
            .array(),
        "BMP data are too short for 65535x4000 pixels");
    assertRefused(little(file.clone()).putInt(14, 13).array(), "BMP has a header of 13 bytes");
  }

  /** Java would decode a JPEG or PNG file inside, without its checks. */
  @ParameterizedTest
  @ValueSource(ints = {4, 5, -1})
  void picturesInsideABmpAreRefused(int compression) {
    byte[] file = little(LegacyFixture.file("bmp", RGB, "")).putInt(30, compression).array();
    assertRefused(
        file, "BMP has the compression " + compression + ", expected 0 to 3; save it as a PNG");
  }

  @Test
  void aSmallGifIsPlacedOnItsScreen() throws IOException {
    byte[] file = LegacyFixture.file("gif", PALETTE, "");
    int descriptor = file.length;
    while (file[--descriptor] != 0x2c || little(file).getShort(descriptor + 5) != 21) {
      // Search backwards.
    }
    byte[] moved =
        little(file.clone())
            .putShort(6, (short) 30)
            .putShort(descriptor + 1, (short) 5)
            .putShort(descriptor + 3, (short) 2)
            .array();
    Pixels small = ImageReader.decode(file);
    Pixels large = ImageReader.decode(moved);
    assertThat(large.width()).isEqualTo(30);
    assertThat(large.height()).isEqualTo(11);
    assertThat(large.alpha(4, 3)).isZero();
    assertThat(large.alpha(5, 1)).isZero();
    assertThat(large.alpha(5, 2)).isEqualTo(255);
    assertThat(large.raw(25, 10, 1)).isEqualTo(small.raw(20, 8, 1));
    byte[] huge =
        little(file.clone())
            .putShort(descriptor + 5, (short) -1)
            .putShort(descriptor + 7, (short) 4000)
            .array();
    assertRefused(huge, "GIF data are too short for 65535x4000 pixels");
    byte[] screen = little(file.clone()).putInt(6, -1).array();
    assertRefused(screen, Limits.NONE, TOO_LARGE, "the picture has 65535x65535 pixels");
    assertRefused(Arrays.copyOf(file, descriptor), "GIF is truncated");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "262|5|CMYK colors, expected gray, RGB or a palette; save it as a PNG",
        "262|32803|colors of the kind 32803",
        "277|5|5 channels, expected gray, RGB or a palette, and alpha",
        "258|32|32 bits per channel, expected 1, 2, 4, 8 or 16",
        "258|3|3 bits per channel",
        "259|7|JPEG compression, expected none, LZW, Deflate, PackBits or fax",
        "259|50000|the compression 50000",
        "279|100000|",
        "273|100000|"
      })
  void kindsOfTiffAreRefusedByName(int tag, int value, String found) {
    byte[] file = LegacyFixture.with(LegacyFixture.file("tiff", RGB, "LZW"), tag, value);
    assertRefused(
        file,
        found == null ? "TIFF is truncated: its data end beyond the file" : "TIFF has " + found);
  }

  @Test
  void sizesOfTiffAreCheckedFirst() {
    byte[] file = LegacyFixture.file("tiff", RGB, "LZW");
    assertRefused(
        LegacyFixture.with(file, 256, 60000), "TIFF data are too short for 60000x9 pixels");
    assertRefused(
        LegacyFixture.with(file, 256, 70000),
        Limits.NONE,
        TOO_LARGE,
        "the picture has 70000x9 pixels");
    assertRefused(LegacyFixture.with(file, 256, 0), "the picture has no pixels");
    assertRefused(Arrays.copyOf(file, 9), "TIFF is truncated");
    byte[] big = file.clone();
    big[file[0] == 'I' ? 2 : 3] = 43;
    assertRefused(big, "TIFF is a BigTIFF file");
  }

  @ParameterizedTest
  @ValueSource(strings = {"bmp", "gif", "tiff"})
  void anInterruptEndsDecoding(String format) {
    byte[] file = LegacyFixture.file(format, PALETTE, "");
    assertCancelled(() -> ImageReader.decode(file));
  }

  @Test
  void pluginsAreNotUsed() {
    List<String> formats = List.of("BMP", "GIF", "TIFF", "PNG", "JPEG");
    assertThat(formats)
        .allSatisfy(
            format ->
                assertThat(JdkDecoder.reader(format).getClass().getModule().getName())
                    .isEqualTo("java.desktop"));
  }
}
