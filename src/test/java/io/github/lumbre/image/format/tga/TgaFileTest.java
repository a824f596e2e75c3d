package io.github.lumbre.image.format.tga;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import java.io.IOException;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of TGA files of all kinds. */
class TgaFileTest {
  private static byte[] bytes(int... values) {
    byte[] bytes = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      bytes[i] = (byte) values[i];
    }
    return bytes;
  }

  private static int[] color(Pixels pixels, int x, int y) {
    int[] rgb = {pixels.raw(x, y, 0), pixels.raw(x, y, 1), pixels.raw(x, y, 2)};
    return pixels.hasAlpha() ? new int[] {rgb[0], rgb[1], rgb[2], pixels.alpha(x, y)} : rgb;
  }

  private static void assertRefused(byte[] file, ImageFormatException.Kind kind, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(kind))
        .hasMessage(message);
  }

  @ParameterizedTest
  @CsvSource({"0, 0, 1", "0x10, 1, 1", "0x20, 0, 0", "0x30, 1, 0"})
  void theFirstPixelIsInTheCornerOfTheDescriptor(String descriptor, int x, int y)
      throws IOException {
    TgaFixture fixture = new TgaFixture(2, 24, Integer.decode(descriptor), 0);
    byte[] pixels = bytes(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);
    Pixels picture = ImageReader.decode(fixture.file(2, 2, pixels));
    assertThat(color(picture, x, y)).containsExactly(3, 2, 1);
    assertThat(color(picture, 1 - x, y)).containsExactly(6, 5, 4);
    assertThat(color(picture, x, 1 - y)).containsExactly(9, 8, 7);
    assertThat(color(picture, 1 - x, 1 - y)).containsExactly(12, 11, 10);
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 10})
  void bitsBeyondColorAreAlphaIfTheDescriptorCountsThem(int type) throws IOException {
    byte[] pixels = bytes(1, 2, 3, 4, 1, 2, 3, 4, 9, 8, 7, 6);
    Pixels opaque = ImageReader.decode(new TgaFixture(type, 32, 0, 0).file(3, 1, pixels));
    assertThat(color(opaque, 2, 0)).containsExactly(7, 8, 9);
    Pixels clear = ImageReader.decode(new TgaFixture(type, 32, 8, 0).file(3, 1, pixels));
    assertThat(color(clear, 1, 0)).containsExactly(3, 2, 1, 4);
    assertThat(color(clear, 2, 0)).containsExactly(7, 8, 9, 6);
  }

  /** Many programs count bits of alpha and write 0 for an opaque picture. */
  @Test
  void anAlphaOfZeroEverywhereIsNone() throws IOException {
    byte[] zeros = bytes(1, 2, 3, 0, 9, 8, 7, 0);
    for (int type : new int[] {2, 10}) {
      Pixels color = ImageReader.decode(new TgaFixture(type, 32, 8, 0).file(2, 1, zeros));
      assertThat(color.hasAlpha()).isFalse();
      assertThat(color(color, 1, 0)).containsExactly(7, 8, 9);
    }
    byte[] dark = bytes(0x1f, 0x02, 0x00, 0x04);
    Pixels packed = ImageReader.decode(new TgaFixture(2, 16, 1, 0).file(2, 1, dark));
    assertThat(color(packed, 0, 0)).containsExactly(0, 132, 255);
    Pixels gray = ImageReader.decode(new TgaFixture(3, 16, 8, 0).file(2, 1, bytes(5, 0, 200, 0)));
    assertThat(color(gray, 1, 0)).containsExactly(200, 200, 200);
    byte[] palette = bytes(1, 2, 3, 0, 4, 5, 6, 0);
    int first = TgaFixture.FIRST;
    Pixels mapped =
        ImageReader.decode(
            new TgaFixture(1, 8, 8, 32, palette).file(2, 1, bytes(first, first + 1)));
    assertThat(color(mapped, 1, 0)).containsExactly(6, 5, 4);
  }

  @Test
  void fiveBitsAreScaledToEight() throws IOException {
    // 1 00000 10000 11111 and 0 00001 00000 00000
    byte[] pixels = bytes(0x1f, 0x82, 0x00, 0x04);
    for (int depth : new int[] {15, 16}) {
      Pixels opaque = ImageReader.decode(new TgaFixture(2, depth, 0, 0).file(2, 1, pixels));
      assertThat(color(opaque, 0, 0)).containsExactly(0, 132, 255);
      assertThat(color(opaque, 1, 0)).containsExactly(8, 0, 0);
    }
    Pixels clear = ImageReader.decode(new TgaFixture(2, 16, 1, 0).file(2, 1, pixels));
    assertThat(color(clear, 0, 0)).containsExactly(0, 132, 255, 255);
    assertThat(color(clear, 1, 0)).containsExactly(8, 0, 0, 0);
  }

  @Test
  void grayMayHaveAlpha() throws IOException {
    Pixels plain = ImageReader.decode(new TgaFixture(3, 8, 0, 0).file(2, 1, bytes(5, 200)));
    assertThat(color(plain, 1, 0)).containsExactly(200, 200, 200);
    byte[] two = bytes(5, 6, 200, 7);
    Pixels opaque = ImageReader.decode(new TgaFixture(3, 16, 0, 0).file(2, 1, two));
    assertThat(color(opaque, 1, 0)).containsExactly(200, 200, 200);
    Pixels clear = ImageReader.decode(new TgaFixture(11, 16, 8, 0).file(2, 1, two));
    assertThat(color(clear, 1, 0)).containsExactly(200, 200, 200, 7);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 9})
  void palettesAreLookedUpFromTheirFirstIndex(int type) throws IOException {
    byte[] palette = bytes(1, 2, 3, 4, 5, 6, 7, 8);
    byte[] narrow = bytes(4, 4, 3);
    Pixels pixels = ImageReader.decode(new TgaFixture(type, 8, 8, 32, palette).file(3, 1, narrow));
    assertThat(color(pixels, 0, 0)).containsExactly(7, 6, 5, 8);
    assertThat(color(pixels, 2, 0)).containsExactly(3, 2, 1, 4);
    byte[] wide = bytes(4, 0, 4, 0, 3, 0);
    Pixels same = ImageReader.decode(new TgaFixture(type, 16, 0, 32, palette).file(3, 1, wide));
    assertThat(color(same, 0, 0)).containsExactly(7, 6, 5);
    for (int index : new int[] {2, 5, 255}) {
      assertRefused(
          new TgaFixture(type, 8, 0, 32, palette).file(3, 1, bytes(3, 3, index)),
          ImageFormatException.Kind.MALFORMED,
          "TGA has the color " + index + ", expected 3 to 4");
    }
  }

  @Test
  void packedFilesHaveTheSamePixels() throws IOException {
    for (int i = 0; i < 16; i++) {
      Pixels plain = ImageReader.decode(TgaFixture.files().toList().get(i));
      Pixels packed = ImageReader.decode(TgaFixture.files().toList().get(16 + i));
      assertThat(packed.hasAlpha()).isEqualTo(plain.hasAlpha());
      for (int y = 0; y < 5; y++) {
        for (int x = 0; x < 7; x++) {
          assertThat(color(packed, x, y)).isEqualTo(color(plain, x, y));
        }
      }
    }
  }

  @Test
  void aPaletteThatNoPixelUsesIsSkipped() throws IOException {
    byte[] file = new TgaFixture(2, 24, 0, 24, bytes(1, 2, 3)).file(1, 1, bytes(7, 8, 9));
    assertThat(color(ImageReader.decode(file), 0, 0)).containsExactly(9, 8, 7);
  }

  @Test
  void shortDataAreRefusedBeforeMemoryIsAllocated() {
    for (int type : new int[] {2, 10}) {
      byte[] file = new TgaFixture(type, 32, 8, 0).file(65535, 4000, bytes(1, 2, 3, 4));
      assertRefused(
          file,
          ImageFormatException.Kind.MALFORMED,
          "TGA data are too short for 65535x4000 pixels");
    }
    byte[] file =
        new TgaFixture(10, 24, 0, 0).file(5, 1, bytes(1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6, 7, 8, 9));
    assertRefused(
        Arrays.copyOf(file, file.length - 1),
        ImageFormatException.Kind.MALFORMED,
        "TGA is truncated");
    assertRefused(
        new TgaFixture(2, 24, 0, 0).file(65535, 65535, new byte[0]),
        ImageFormatException.Kind.TOO_LARGE,
        "the picture has 65535x65535 pixels, expected at most 65535 per side and 268435456 in"
            + " total");
    assertRefused(
        new TgaFixture(2, 24, 0, 0).file(0, 5, new byte[0]),
        ImageFormatException.Kind.MALFORMED,
        "the picture has no pixels");
  }

  @Test
  void filesOfOtherKindsAreRecognizedByTheirFooter() {
    byte[] file = new TgaFixture(32, 8, 0, 24, bytes(1, 2, 3)).file(1, 1, bytes(0));
    assertThat(TgaFile.isIn(file)).isFalse();
    assertRefused(
        TgaFixture.withFooter(file),
        ImageFormatException.Kind.MALFORMED,
        "TGA has the image type 32, 8 bits per pixel, 1 colors of 24 bits and the descriptor 0;"
            + " expected the type 1, 2, 3, 9, 10 or 11 with 8 to 32 bits, not interleaved");
  }

  @Test
  void otherFilesAreNotTakenForPictures() {
    byte[] icon = bytes(0, 0, 1, 0, 1, 0, 32, 32, 0, 0, 1, 0, 32, 0, 0xa8, 0x10, 0, 0, 22, 0, 0, 0);
    assertThat(TgaFile.isIn(icon)).isFalse();
    assertThat(TgaFile.isIn(new byte[100])).isFalse();
    assertThat(TgaFile.isIn(new byte[17])).isFalse();
    byte[] file = TgaFixture.files().findFirst().orElseThrow();
    assertThat(TgaFile.isIn(file)).isTrue();
  }
}
