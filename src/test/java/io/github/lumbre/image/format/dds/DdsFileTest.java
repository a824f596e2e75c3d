package io.github.lumbre.image.format.dds;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageFormatException.Kind;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import java.io.IOException;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of DDS files of all kinds. */
class DdsFileTest {
  private static int[] color(Pixels pixels, int x, int y) {
    return new int[] {
      pixels.raw(x, y, 0), pixels.raw(x, y, 1), pixels.raw(x, y, 2), pixels.alpha(x, y)
    };
  }

  private static void assertRefused(byte[] file, String message) {
    assertThatThrownBy(() -> ImageReader.decode(file))
        .isInstanceOfSatisfying(
            ImageFormatException.class, e -> assertThat(e.kind()).isEqualTo(Kind.MALFORMED))
        .hasMessage(message);
  }

  private static byte[] bytes(String hex) {
    return HexFormat.of().parseHex(hex.replace(" ", ""));
  }

  /** The hashes are those of the decoder texture2ddecoder 1.0.6, of 4096 random blocks a mode. */
  @ParameterizedTest
  @CsvSource({
    "0, d3618a40c41dcf2f",
    "1, 5ffd35570736e784",
    "2, b8f6f55062608cbc",
    "3, b3a6e9d2962e774f",
    "4, 1befb27a8d6fcc24",
    "5, 920e8dc48b0a3165",
    "6, 4407a3c84801ac77",
    "7, a96aa11f9f63d45f"
  })
  void bc7HasTheValuesOfAnotherDecoder(int mode, String hash)
      throws IOException, NoSuchAlgorithmException {
    byte[] file = DdsFixture.numbered(98, 256, 256, DdsFixture.bc7(mode, 4096));
    Pixels pixels = ImageReader.decode(file);
    byte[] values = new byte[4 * 256 * 256];
    for (int i = 0; i < values.length; i++) {
      int pixel = i / 4;
      values[i] = (byte) color(pixels, pixel % 256, pixel / 256)[i % 4];
    }
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(values);
    assertThat(HexFormat.of().formatHex(digest)).startsWith(hash);
  }

  @Test
  void theReservedModeOfBc7IsTransparentBlack() throws IOException {
    Pixels pixels = ImageReader.decode(DdsFixture.numbered(99, 4, 4, new byte[16]));
    assertThat(color(pixels, 3, 3)).containsExactly(0, 0, 0, 0);
  }

  /** White and black, and rows of all four choices. */
  @Test
  void bc1InterpolatesAndMayBeTransparent() throws IOException {
    Pixels four = ImageReader.decode(DdsFixture.named("DXT1", 4, 4, bytes("ffff 0000 e4e4e4e4")));
    assertThat(color(four, 0, 0)).containsExactly(255, 255, 255, 255);
    assertThat(color(four, 1, 1)).containsExactly(0, 0, 0, 255);
    assertThat(color(four, 2, 2)).containsExactly(170, 170, 170, 255);
    assertThat(color(four, 3, 3)).containsExactly(85, 85, 85, 255);
    Pixels three = ImageReader.decode(DdsFixture.named("DXT1", 4, 4, bytes("0000 ffff e4e4e4e4")));
    assertThat(color(three, 2, 0)).containsExactly(128, 128, 128, 255);
    assertThat(color(three, 3, 0)).containsExactly(0, 0, 0, 0);
  }

  @Test
  void bc2AndBc3HaveAlphaOfTheirOwn() throws IOException {
    byte[] two = bytes("10325476 98badcfe 0000 ffff e4e4e4e4");
    Pixels bc2 = ImageReader.decode(DdsFixture.named("DXT3", 4, 4, two));
    assertThat(color(bc2, 2, 0)).containsExactly(85, 85, 85, 2 * 17);
    assertThat(bc2.alpha(3, 3)).isEqualTo(15 * 17);
    // The choices 0 to 7, and 0 to 7 again.
    byte[] three = bytes("7000 88c6fa 88c6fa 0000 ffff e4e4e4e4");
    Pixels bc3 = ImageReader.decode(DdsFixture.named("DXT5", 4, 4, three));
    int[] expected = {112, 0, 96, 80, 64, 48, 32, 16};
    byte[] reversed = bytes("0064 88c6fa 88c6fa 0000 ffff e4e4e4e4");
    Pixels few = ImageReader.decode(DdsFixture.named("DXT5", 4, 4, reversed));
    int[] fewExpected = {0, 100, 20, 40, 60, 80, 0, 255};
    for (int i = 0; i < 8; i++) {
      assertThat(bc3.alpha(i % 4, i / 4)).isEqualTo(expected[i]);
      assertThat(few.alpha(i % 4, i / 4)).isEqualTo(fewExpected[i]);
    }
  }

  @Test
  void bc4IsGrayAndBc5IsANormalMap() throws IOException {
    Pixels gray = ImageReader.decode(DdsFixture.named("ATI1", 1, 1, bytes("7000 000000 000000")));
    assertThat(color(gray, 0, 0)).containsExactly(112, 112, 112, 255);
    byte[] level = bytes("8000 000000 000000 8000 000000 000000");
    Pixels up = ImageReader.decode(DdsFixture.named("ATI2", 1, 1, level));
    assertThat(color(up, 0, 0)).containsExactly(128, 128, 255, 255);
    byte[] steep = bytes("ff00 000000 000000 8000 000000 000000");
    Pixels aside = ImageReader.decode(DdsFixture.numbered(83, 1, 1, steep));
    assertThat(color(aside, 0, 0)).containsExactly(255, 128, 128, 255);
  }

  @Test
  void masksDivideAPixel() throws IOException {
    int[] masks = {0xff0000, 0xff00, 0xff, 0xff000000};
    byte[] one = bytes("01020304");
    assertThat(color(ImageReader.decode(DdsFixture.masked(0x41, 32, masks, 1, 1, one)), 0, 0))
        .containsExactly(3, 2, 1, 4);
    assertThat(color(ImageReader.decode(DdsFixture.masked(0x40, 32, masks, 1, 1, one)), 0, 0))
        .containsExactly(3, 2, 1, 255);
    assertThat(color(ImageReader.decode(DdsFixture.numbered(28, 1, 1, one)), 0, 0))
        .containsExactly(1, 2, 3, 4);
    assertThat(color(ImageReader.decode(DdsFixture.numbered(88, 1, 1, one)), 0, 0))
        .containsExactly(3, 2, 1, 255);
    int[] five = {0xf800, 0x7e0, 0x1f, 0};
    byte[] packed = bytes("1ff8");
    assertThat(color(ImageReader.decode(DdsFixture.masked(0x40, 16, five, 1, 1, packed)), 0, 0))
        .containsExactly(255, 0, 255, 255);
    int[] gray = {0xff, 0, 0, 0xff00};
    assertThat(color(ImageReader.decode(DdsFixture.masked(0x20001, 16, gray, 1, 1, one)), 0, 0))
        .containsExactly(1, 1, 1, 2);
  }

  @Test
  void blocksAreCutAtTheEdges() throws IOException {
    byte[] data = DdsFixture.data(1, 64);
    Pixels whole = ImageReader.decode(DdsFixture.named("DXT5", 8, 8, data));
    Pixels cut = ImageReader.decode(DdsFixture.named("DXT5", 5, 6, data));
    for (int i = 0; i < 30; i++) {
      assertThat(color(cut, i % 5, i / 5)).isEqualTo(color(whole, i % 5, i / 5));
    }
  }

  @Test
  void otherKindsAreRefusedByName() {
    String expected = ", expected BC1 to BC5, BC7, or gray, RGB or RGBA; save it as a PNG";
    byte[] data = new byte[64];
    assertRefused(DdsFixture.numbered(95, 4, 4, data), "DDS has the format BC6H" + expected);
    assertRefused(DdsFixture.numbered(84, 4, 4, data), "DDS has the format BC5_SNORM" + expected);
    assertRefused(DdsFixture.numbered(2, 4, 4, data), "DDS has the DXGI format 2" + expected);
    assertRefused(DdsFixture.named("DXT2", 4, 4, data), "DDS has the format DXT2" + expected);
    assertRefused(DdsFixture.named("q\0\0\0", 4, 4, data), "DDS has the format 113" + expected);
    assertRefused(
        DdsFixture.masked(0x20, 8, new int[0], 4, 4, data),
        "DDS has pixels of 8 bits with the flags 32" + expected);
    byte[] plain = DdsFixture.named("DXT1", 4, 4, data);
    byte[] extended = DdsFixture.numbered(71, 4, 4, data);
    String one = " of pictures, expected one picture";
    assertRefused(DdsFixture.with(plain, 112, 0x200), "DDS has a cube map" + one);
    assertRefused(DdsFixture.with(plain, 112, 0x200000), "DDS has a volume or a line" + one);
    assertRefused(DdsFixture.with(extended, 136, 4), "DDS has a cube map" + one);
    assertRefused(DdsFixture.with(extended, 132, 4), "DDS has a volume or a line" + one);
    assertRefused(DdsFixture.with(extended, 140, 2), "DDS has an array" + one);
  }

  @Test
  void shortDataAreRefusedBeforeMemoryIsAllocated() {
    byte[] file = DdsFixture.named("DXT1", 65535, 4000, new byte[64]);
    assertRefused(file, "DDS data are too short for 65535x4000 pixels");
    assertRefused(Arrays.copyOf(file, 127), "DDS is truncated");
    assertRefused(
        Arrays.copyOf(DdsFixture.numbered(98, 4, 4, new byte[16]), 147), "DDS is truncated");
    assertRefused(DdsFixture.named("DXT1", 0, 4, new byte[8]), "the picture has no pixels");
    assertRefused(
        DdsFixture.named("DXT1", 5, 4, new byte[15]), "DDS data are too short for 5x4 pixels");
  }
}
