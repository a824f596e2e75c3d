package io.github.lumbre.image;

import static io.github.lumbre.testing.Pictures.assertSame;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.format.png.PngFixture;
import io.github.lumbre.image.internal.EncodedFormat;
import io.github.lumbre.image.internal.PictureLimits;
import io.github.lumbre.testing.Pictures;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.SplittableRandom;
import java.util.function.IntBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of valid, damaged and malicious PNG and JPEG files. */
class ImageReaderTest {
  /** 8×8 texels of the inks (0, 128, 255, 64), inverted as Adobe does. */
  private static final String FOUR_INKS =
      "/9j/7gAOQWRvYmUAZAAAAAAA/9sAQwADAgIDAgIDAwMDBAMDBAUIBQUEBAUKBwcGCAwKDAwLCgsLDQ4SEA0OEQ4LCxAW"
          + "EBETFBUVFQwPFxgWFBgSFBUU/8AAFAgACAAIBEMRAE0RAFkRAEsRAP/EABYAAQEBAAAAAAAAAAAAAAAAAAkC"
          + "CP/EABQQAQAAAAAAAAAAAAAAAAAAAAD/2gAOBEMATQBZAEsAAD8AVNAqmqH/2Q==";

  private static void assertMalformed(byte[] file, String message) {
    assertRefused(file, ImageFormatException.Kind.MALFORMED, message);
  }

  private static void assertRefused(byte[] file, ImageFormatException.Kind kind, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(kind))
        .hasMessageStartingWith(message);
  }

  private static IntBinaryOperator noise(int depth) {
    return (x, y) -> (x * 7919 + y * 104729 + (x ^ y) * 31) & ((1 << depth) - 1);
  }

  private static byte[] png(int width, int height, int depth, int colorType, boolean interlaced) {
    return new PngFixture()
        .header(width, height, depth, colorType, interlaced)
        .data(width, height, depth, colorType, interlaced, noise(depth))
        .end();
  }

  @ParameterizedTest
  @CsvSource({
    "0, 1", "0, 2", "0, 4", "0, 8", "0, 16", "2, 8", "2, 16", "4, 8", "4, 16", "6, 8", "6, 16"
  })
  void everyKindOfPngIsReadExactly(int colorType, int depth) throws IOException {
    int channels = PngFixture.channels(colorType);
    int max = (1 << depth) - 1;
    for (boolean interlaced : new boolean[] {false, true}) {
      Pixels pixels = ImageReader.decode(png(21, 13, depth, colorType, interlaced));
      assertThat(pixels.width()).isEqualTo(21);
      assertThat(pixels.height()).isEqualTo(13);
      assertThat(pixels.max()).isEqualTo(depth == 16 ? 65535 : 255);
      for (int y = 0; y < 13; y++) {
        for (int x = 0; x < 21; x++) {
          for (int c = 0; c < 3; c++) {
            int at = channels * x + (channels < 3 ? 0 : c);
            int expected = noise(depth).applyAsInt(at, y) * (pixels.max() / max);
            assertThat(pixels.raw(x, y, c)).isEqualTo(expected);
            assertThat(pixels.value(x, y, c)).isEqualTo((double) expected / pixels.max());
          }
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 4, 8})
  void palettesAreLookedUp(int depth) throws IOException {
    byte[] palette = new byte[3 << depth];
    new SplittableRandom(depth).nextBytes(palette);
    for (boolean interlaced : new boolean[] {false, true}) {
      byte[] file =
          new PngFixture()
              .header(19, 11, depth, PngFixture.PALETTE, interlaced)
              .chunk("PLTE", palette)
              .chunk("tRNS", new byte[] {0, 100})
              .data(19, 11, depth, PngFixture.PALETTE, interlaced, noise(depth))
              .end();
      Pixels pixels = ImageReader.decode(file);
      for (int y = 0; y < 11; y++) {
        for (int x = 0; x < 19; x++) {
          for (int c = 0; c < 3; c++) {
            int entry = palette[3 * noise(depth).applyAsInt(x, y) + c] & 0xff;
            assertThat(pixels.raw(x, y, c)).isEqualTo(entry);
          }
        }
      }
    }
  }

  @Test
  void gammaAndProfilesAreIgnored() throws IOException {
    byte[] profile = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
    ByteArrayOutputStream named = new ByteArrayOutputStream();
    named.writeBytes("linear\0\0".getBytes(StandardCharsets.US_ASCII));
    named.writeBytes(PngFixture.deflated(profile));
    for (int colorType : new int[] {PngFixture.GRAY, PngFixture.RGB}) {
      Pixels plain = ImageReader.decode(png(9, 9, 8, colorType, false));
      for (byte[] file :
          new byte[][] {
            new PngFixture()
                .header(9, 9, 8, colorType, false)
                .chunk("gAMA", new byte[] {0, 1, (byte) 0x86, (byte) 0xa0})
                .data(9, 9, 8, colorType, false, noise(8))
                .end(),
            new PngFixture()
                .header(9, 9, 8, colorType, false)
                .chunk("iCCP", named.toByteArray())
                .data(9, 9, 8, colorType, false, noise(8))
                .end()
          }) {
        assertSame(ImageReader.decode(file), plain);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "65500, 1", "1, 65500"})
  void extremeSizesAreRead(int width, int height) throws IOException {
    Pixels pixels = ImageReader.decode(png(width, height, 8, PngFixture.RGB, false));
    assertThat(pixels.raw(width - 1, height - 1, 2))
        .isEqualTo(noise(8).applyAsInt(3 * width - 1, height - 1));
  }

  private static byte[] jpeg(int imageType) throws IOException {
    BufferedImage picture = new BufferedImage(40, 24, imageType);
    for (int y = 0; y < 24; y++) {
      for (int x = 0; x < 40; x++) {
        picture.setRGB(x, y, x < 20 ? 0xc06020 : 0x2060c0);
      }
    }
    return Pictures.file(picture, "jpeg");
  }

  @Test
  void jpegColorsAreRead() throws IOException {
    Pixels pixels = ImageReader.decode(jpeg(BufferedImage.TYPE_INT_RGB));
    assertThat(pixels.width()).isEqualTo(40);
    assertThat(pixels.height()).isEqualTo(24);
    assertThat(pixels.max()).isEqualTo(255);
    int[] left = {0xc0, 0x60, 0x20};
    for (int c = 0; c < 3; c++) {
      assertThat(pixels.raw(3, 3, c)).isCloseTo(left[c], within(3));
      assertThat(pixels.raw(36, 20, c)).isCloseTo(left[2 - c], within(3));
    }
  }

  @Test
  void jpegGraysAreReadAsTheyAre() throws IOException {
    BufferedImage picture = new BufferedImage(16, 16, BufferedImage.TYPE_BYTE_GRAY);
    int[] hundred = new int[256];
    Arrays.fill(hundred, 100);
    picture.getRaster().setPixels(0, 0, 16, 16, hundred);
    Pixels pixels = ImageReader.decode(Pictures.file(picture, "jpeg"));
    for (int c = 0; c < 3; c++) {
      assertThat(pixels.raw(7, 9, c)).isCloseTo(100, within(1));
    }
  }

  @Test
  void jpegInksAreTurnedIntoColors() throws IOException {
    Pixels pixels = ImageReader.decode(Base64.getDecoder().decode(FOUR_INKS));
    assertThat(pixels.raw(3, 3, 0)).isCloseTo(191, within(1));
    assertThat(pixels.raw(3, 3, 1)).isCloseTo(95, within(1));
    assertThat(pixels.raw(3, 3, 2)).isCloseTo(0, within(1));
  }

  @Test
  void jpegProfilesAreIgnored() throws IOException {
    byte[] plain = jpeg(BufferedImage.TYPE_INT_RGB);
    byte[] profile = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    // Insert the segment after the JFIF marker, which follows the two bytes of the start.
    int jfif = 4 + (plain[4] << 8 | plain[5]);
    out.write(plain, 0, jfif);
    int length = 16 + profile.length;
    out.writeBytes(new byte[] {(byte) 0xff, (byte) 0xe2, (byte) (length >> 8), (byte) length});
    out.writeBytes("ICC_PROFILE\0\1\1".getBytes(StandardCharsets.US_ASCII));
    out.writeBytes(profile);
    out.write(plain, jfif, plain.length - jfif);
    assertSame(ImageReader.decode(out.toByteArray()), ImageReader.decode(plain));
  }

  @Test
  void jpegWithoutAnyMarkerIsReadAsIfItHadOne() throws IOException {
    byte[] plain = jpeg(BufferedImage.TYPE_INT_RGB);
    int jfif = 4 + (plain[4] << 8 | plain[5]);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(plain, 0, 2);
    out.write(plain, jfif, plain.length - jfif);
    assertSame(ImageReader.decode(out.toByteArray()), ImageReader.decode(plain));
  }

  @ParameterizedTest
  @CsvSource({"60000, 60000", "16385, 16384", "65536, 1", "1, 65536", "-1, -1", "2147483647, 1"})
  void aPictureBeyondTheLimitsIsRefusedByItsHeaderAlone(int width, int height) {
    byte[] file =
        new PngFixture()
            .header(width, height, 8, PngFixture.RGB, false)
            .chunk("IDAT", PngFixture.deflated(new byte[100]))
            .end();
    assertRefused(file, ImageFormatException.Kind.TOO_LARGE, "the picture has ");
  }

  @Test
  void aLargeClaimOverLittleDataTakesNoMemory() {
    byte[] png =
        new PngFixture()
            .header(16384, 16384, 16, PngFixture.RGBA, false)
            .chunk("IDAT", PngFixture.deflated(new byte[1 << 16]))
            .end();
    assertMalformed(png, "PNG data are too short for 16384x16384 pixels");
  }

  @Test
  void aPictureLargerThanTheHeapIsRefusedBeforeItIsDecoded() {
    assertThatCode(() -> PictureLimits.checkMemory(1024, 512, 2, Limits.NONE.withMemory(1 << 20)))
        .doesNotThrowAnyException();
    assertThatThrownBy(
            () -> PictureLimits.checkMemory(2048, 1024, 1, Limits.NONE.withMemory(1 << 20)))
        .hasMessage(
            "the picture has 2048x1024 pixels: expected at most 1048576 bytes of memory, found"
                + " 2097152");
  }

  @Test
  void aJpegThatClaimsTooMuchIsRefused() throws IOException {
    byte[] file = jpeg(BufferedImage.TYPE_INT_RGB);
    int frame = frameOf(file);
    Arrays.fill(file, frame + 5, frame + 9, (byte) 0xf0);
    assertRefused(file, ImageFormatException.Kind.TOO_LARGE, "the picture has 61680x61680 pixels");
    Arrays.fill(file, frame + 5, frame + 9, (byte) 0x30);
    assertMalformed(file, "JPEG data are too short for 12336x12336 pixels");
    Arrays.fill(file, frame + 5, frame + 7, (byte) 0);
    assertMalformed(file, "the picture has no pixels");
  }

  private static int frameOf(byte[] jpeg) {
    int at = 2;
    while ((jpeg[at + 1] & 0xff) != 0xc0) {
      at += 2 + ((jpeg[at + 2] & 0xff) << 8 | jpeg[at + 3] & 0xff);
    }
    return at;
  }

  @Test
  void compressedTextIsNeverInflated() throws IOException {
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    text.writeBytes("Comment\0\0".getBytes(StandardCharsets.US_ASCII));
    text.writeBytes(PngFixture.deflated(new byte[1 << 24]));
    byte[] file =
        new PngFixture()
            .header(2, 2, 8, PngFixture.GRAY, false)
            .chunk("zTXt", text.toByteArray())
            .data(2, 2, 8, PngFixture.GRAY, false, noise(8))
            .end();
    var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    assertThat(ImageReader.decode(file).width()).isEqualTo(2);
    assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(1 << 20);
  }

  @Test
  void aHeaderThatClaimsMoreRowsThanThereAreIsMalformed() {
    byte[] file =
        new PngFixture()
            .header(50, 60, 8, PngFixture.RGB, false)
            .data(50, 50, 8, PngFixture.RGB, false, noise(8))
            .end();
    assertMalformed(file, "PNG ends too early");
  }

  /** What ends a file has no pixels. */
  @Test
  void everyTruncationOfPixelsIsMalformed() throws IOException {
    everyTruncation(png(9, 9, 8, PngFixture.RGB, true), 12);
    everyTruncation(jpeg(BufferedImage.TYPE_INT_RGB), 2);
  }

  private static void everyTruncation(byte[] file, int end) throws IOException {
    Pixels whole = ImageReader.decode(file);
    for (int length = 0; length < file.length; length++) {
      byte[] part = Arrays.copyOf(file, length);
      if (length < file.length - end) {
        assertRefused(part, ImageFormatException.Kind.MALFORMED, "");
      } else {
        assertSame(ImageReader.decode(part), whole);
      }
    }
  }

  @Test
  void jpegDataThatStopEarlyAreMalformedDespiteAnEndMarker() throws IOException {
    int[] noise = new SplittableRandom(3).ints(10_000).toArray();
    byte[] file = Pictures.file(Pictures.of(100, 100, noise), "jpeg");
    byte[] half = Arrays.copyOf(file, file.length / 2);
    half[half.length - 2] = (byte) 0xff;
    half[half.length - 1] = (byte) 0xd9;
    assertMalformed(half, "JPEG is damaged: ");
  }

  @Test
  void everyFlippedByteOfAPngIsNoticedOrHarmless() throws IOException {
    byte[] file = png(9, 9, 8, PngFixture.RGB, false);
    Pixels sound = ImageReader.decode(file);
    for (int i = 0; i < file.length; i++) {
      byte[] flipped = file.clone();
      flipped[i] ^= 0x55;
      Throwable thrown = catchThrowable(() -> assertSame(ImageReader.decode(flipped), sound));
      assertThat(thrown).isInstanceOf(ImageFormatException.class);
    }
  }

  @Test
  void damagedFilesNeverCauseAnotherException() throws IOException {
    SplittableRandom random = new SplittableRandom(11);
    byte[][] files = {
      jpeg(BufferedImage.TYPE_INT_RGB),
      jpeg(BufferedImage.TYPE_BYTE_GRAY),
      Base64.getDecoder().decode(FOUR_INKS)
    };
    for (int run = 0; run < 1500; run++) {
      byte[] file = files[run % files.length].clone();
      for (int flips = 1 + random.nextInt(3); flips > 0; flips--) {
        file[2 + random.nextInt(file.length - 2)] = (byte) random.nextInt();
      }
      Throwable thrown = catchThrowable(() -> ImageReader.decode(file));
      if (thrown != null) {
        assertThat(thrown).isInstanceOf(ImageFormatException.class);
      }
    }
  }

  @Test
  void pngWithContradictoryChunksNeverCausesAnotherException() {
    for (int colorType = 0; colorType < 8; colorType++) {
      for (int depth : new int[] {0, 1, 3, 8, 16, 32, 255}) {
        byte[] file =
            new PngFixture()
                .header(4, 4, depth, colorType, false)
                .chunk("PLTE", new byte[] {1, 2})
                .chunk("IDAT", PngFixture.deflated(new byte[200]))
                .end();
        Throwable thrown = catchThrowable(() -> ImageReader.decode(file));
        if (thrown != null) {
          assertThat(thrown).isInstanceOf(ImageFormatException.class);
        }
      }
    }
  }

  @Test
  void anIndexBeyondThePaletteDoesNotEscape() throws IOException {
    byte[] file =
        new PngFixture()
            .header(4, 4, 8, PngFixture.PALETTE, false)
            .chunk("PLTE", new byte[] {9, 9, 9})
            .data(4, 4, 8, PngFixture.PALETTE, false, (x, y) -> 200)
            .end();
    assertThat(ImageReader.decode(file).raw(0, 0, 0)).as("black").isZero();
  }

  @Test
  void aSecondHeaderIsMalformed() {
    byte[] file =
        new PngFixture()
            .header(1, 1, 8, PngFixture.RGB, false)
            .header(60000, 60000, 8, PngFixture.RGB, false)
            .data(1, 1, 8, PngFixture.RGB, false, noise(8))
            .end();
    assertMalformed(file, "PNG has two headers");
  }

  @Test
  void aFileWithoutEndHasAllPixels() throws IOException {
    PngFixture rows = new PngFixture().header(4, 2, 8, PngFixture.RGB, false);
    byte[] half = rows.data(4, 1, 8, PngFixture.RGB, false, noise(8)).unfinished();
    assertMalformed(half, "PNG ends too early");
    byte[] header = new PngFixture().header(1, 1, 8, PngFixture.RGB, false).unfinished();
    assertMalformed(header, "PNG is truncated");
  }

  @Test
  void otherFormatsAreNotEvenTried() {
    byte[] photoshop = "8BPS\0\1".getBytes(StandardCharsets.US_ASCII);
    byte[] garbage = new byte[1000];
    new SplittableRandom(1).nextBytes(garbage);
    String expected = "expected a " + EncodedFormat.titles() + " picture, found ";
    assertMalformed(photoshop, expected + "a Photoshop picture");
    assertMalformed(new byte[0], expected + "an empty file");
    assertMalformed(garbage, expected + "none of them");
    assertMalformed(new byte[] {(byte) 0xff}, expected + "none of them");
  }

  @Test
  void signatureAloneIsATruncatedPng() {
    byte[] signature = Arrays.copyOf(png(1, 1, 8, PngFixture.RGB, false), 8);
    assertMalformed(signature, "PNG is truncated");
    assertMalformed(Arrays.copyOf(signature, 7), "expected a PNG, JPEG");
  }

  @Test
  void picturesUpToTheLimitsAreAllowed() {
    int side = ImageReader.MAX_SIDE;
    for (int[] size : new int[][] {{side, 1}, {1, side}, {1 << 14, 1 << 14}, {4096, 65535}}) {
      assertThatCode(() -> PictureLimits.checkSize(size[0], size[1])).doesNotThrowAnyException();
    }
    for (int[] size : new int[][] {{side + 1, 1}, {1, side + 1}, {(1 << 14) + 1, 1 << 14}}) {
      assertThatThrownBy(() -> PictureLimits.checkSize(size[0], size[1]))
          .isInstanceOf(ImageFormatException.class)
          .hasMessageContaining(size[0] + "x" + size[1]);
    }
    assertThatCode(() -> PictureLimits.checkMemory(1024, 1024, 1, Limits.NONE.withMemory(1 << 20)))
        .doesNotThrowAnyException();
    assertThatThrownBy(
            () -> PictureLimits.checkMemory(1024, 1024, 1, Limits.NONE.withMemory((1 << 20) - 1)))
        .isInstanceOf(ImageFormatException.class);
  }
}
