package io.github.lumbre.image.format.webp;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageFormatException.Kind;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that pictures have the values of libwebp, and why files are refused. */
class WebpFileTest {
  private static final int FRAME = 20;

  static List<WebpSamples.Sample> samples() {
    return WebpSamples.all();
  }

  @ParameterizedTest
  @MethodSource("samples")
  void picturesHaveTheValuesOfLibwebp(WebpSamples.Sample sample) throws Exception {
    Pixels pixels = ImageReader.decode(WebpSamples.file(sample.name()));
    assertThat(pixels.width()).isEqualTo(sample.width());
    assertThat(pixels.height()).isEqualTo(sample.height());
    assertThat(pixels.hasAlpha()).isEqualTo(sample.hasAlpha());
    assertThat(sha256(pixels)).isEqualTo(sample.sha256());
  }

  private static String sha256(Pixels pixels) throws NoSuchAlgorithmException {
    ByteBuffer rgba = ByteBuffer.allocate(4 * pixels.width() * pixels.height());
    for (int i = 0; i < pixels.width() * pixels.height(); i++) {
      int x = i % pixels.width();
      int y = i / pixels.width();
      for (int channel = 0; channel < 3; channel++) {
        rgba.put((byte) pixels.raw(x, y, channel));
      }
      rgba.put((byte) pixels.alpha(x, y));
    }
    return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(rgba.array()));
  }

  private static void assertMalformed(byte[] file, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(Kind.MALFORMED))
        .hasMessage(message);
  }

  @Test
  void animationsAreRefused() {
    assertMalformed(
        WebpSamples.file("animation"), "WebP has an animation, expected a still picture");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"lossy", "lossy-sharp", "alpha-raw", "alpha-filtered", "lossless", "extended"})
  void truncatedFilesAreRefused(String name) {
    byte[] file = WebpSamples.file(name);
    for (int length = 12; length < file.length - 1; length++) {
      assertMalformed(Arrays.copyOf(file, length), "WebP is truncated");
    }
  }

  /** Returns a copy of a simple file whose picture has fewer bytes. */
  private static byte[] shortened(String name, int length) {
    byte[] file = Arrays.copyOf(WebpSamples.file(name), FRAME + length);
    ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).putInt(FRAME - 4, length);
    return file;
  }

  @Test
  void picturesWithoutTheirDataAreRefused() {
    assertMalformed(shortened("lossy", 9), "WebP has no VP8 key frame");
    assertMalformed(shortened("lossy", 10), "VP8 is truncated");
    assertMalformed(shortened("lossy", 100), "VP8 is truncated");
    assertMalformed(shortened("lossless", 4), "WebP has no lossless picture");
    assertMalformed(shortened("lossless", 5), "WebP is truncated");
    assertMalformed(shortened("lossless", 300), "WebP is truncated");
  }

  private static byte[] changed(String name, int at, int value) {
    byte[] file = WebpSamples.file(name);
    file[at] = (byte) value;
    return file;
  }

  @Test
  void headersAreChecked() {
    byte[] lossy = WebpSamples.file("lossy");
    assertMalformed(changed("lossy", FRAME, lossy[FRAME] | 1), "WebP has no VP8 key frame");
    assertMalformed(changed("lossy", FRAME, lossy[FRAME] & ~16), "WebP has no VP8 key frame");
    assertMalformed(changed("lossy", FRAME + 3, 0), "WebP has no VP8 key frame");
    assertMalformed(changed("lossless", FRAME, 0), "WebP has no lossless picture");
    assertMalformed(
        changed("lossless", FRAME + 4, 0x20), "WebP has a lossless picture of an unknown version");
    assertMalformed(
        changed("extended", FRAME + 4, 99),
        "WebP has a picture of 20x10 pixels, but its header does not");
    assertMalformed(changed("lossy", FRAME + 6, 0), "the picture has no pixels");
  }

  @Test
  void unknownCompressionOfAlphaIsRefused() {
    byte[] file = WebpSamples.file("alpha-filtered");
    int alpha = new String(file, StandardCharsets.ISO_8859_1).indexOf("ALPH") + 8;
    file[alpha] |= 2;
    assertThatThrownBy(() -> ImageReader.decode(file))
        .hasMessageStartingWith("WebP has alpha with the unknown compression ");
  }

  /** A frame of 16383 x 16383 pixels in 300 bytes. */
  @Test
  void moreMacroblocksThanBitsAreRefused() {
    byte[] file = WebpSamples.file("lossy");
    ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).putInt(FRAME + 6, 0x3fff3fff);
    assertMalformed(file, "WebP data are too short for 16383x16383 pixels");
  }

  /** A lossless picture of one color needs no data for its pixels. */
  @Test
  void largePicturesOfFewBytesAreRefusedByTheirSize() {
    byte[] file = WebpSamples.file("lossless-pixel");
    ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).putInt(FRAME + 1, 0xfffffff);
    assertThatThrownBy(() -> ImageReader.decode(file, Limits.UPLOADS))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(Kind.TOO_LARGE))
        .hasMessage("the picture has 16384x16384 pixels, expected at most 67108864 in total");
  }

  @ParameterizedTest
  @ValueSource(strings = {"lossy", "lossless", "alpha-filtered"})
  void decodingEndsWhenItIsInterrupted(String name) {
    assertCancelled(() -> ImageReader.decode(WebpSamples.file(name)));
  }

  @Test
  void profilesAreNamed() {
    assertThat(ImageReader.ignoredColorSpace(WebpSamples.file("extended")))
        .contains("an ICC profile");
    assertThat(ImageReader.ignoredColorSpace(WebpSamples.file("lossy"))).isEmpty();
    assertThat(ImageReader.ignoredColorSpace(Arrays.copyOf(WebpSamples.file("lossy"), 40)))
        .isEmpty();
  }
}
