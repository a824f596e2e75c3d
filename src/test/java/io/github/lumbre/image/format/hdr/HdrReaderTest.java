package io.github.lumbre.image.format.hdr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.LinearReader;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of Radiance pictures. */
class HdrReaderTest {
  /** Returns a file with the given lines, separated by semicolons, and bytes. */
  private static byte[] file(String header, int... data) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    String text = "#?RADIANCE;" + header + ";";
    out.writeBytes(text.replace(';', '\n').getBytes(StandardCharsets.US_ASCII));
    for (int b : data) {
      out.write(b);
    }
    return out.toByteArray();
  }

  private static Image read(String header, int... data) throws ImageFormatException {
    return LinearReader.decode(file(header, data));
  }

  private static String refusal(byte[] file) {
    try {
      LinearReader.decode(file);
      return "none";
    } catch (ImageFormatException e) {
      return e.getMessage();
    }
  }

  @Test
  void componentsShareAnExponent() throws ImageFormatException {
    Image image =
        read("# a;FORMAT=32-bit_rle_rgbe;;-Y 1 +X 3", 128, 64, 0, 129, 255, 1, 2, 120, 9, 9, 9, 0);
    assertThat(image.rgb())
        .containsExactly(1, .5f, 0, 255 * 0x1p-16f, 0x1p-16f, 2 * 0x1p-16f, 0, 0, 0);
    assertThat(image.hasAlpha()).isFalse();
  }

  /** The matrix is that of ITU-R BT.2087, of colors of equal exponents. */
  @Test
  void colorsOfOtherPrimariesAreConverted() throws ImageFormatException {
    String wide = "PRIMARIES= .708 .292 .17 .797 .131 .046 .3127 .329;;-Y 1 +X 1";
    Image image = read(wide, 128, 64, 64, 129);
    assertThat(image.rgb()[0]).isCloseTo(1.3302f, within(1e-3f));
    assertThat(image.rgb()[1]).isCloseTo(.4377f, within(1e-3f));
    assertThat(image.rgb()[2]).isCloseTo(.4909f, within(1e-3f));
    for (String usual :
        new String[] {
          ".64 .33 .29 .6 .15 .06 .333 .333", ".64 .33 .3 .6 .15 .06 .3127 .329", "1 2", "x",
          "0 0 0 0 0 0 0 0"
        }) {
      Image same = read("PRIMARIES=" + usual + ";;-Y 1 +X 1", 128, 64, 64, 129);
      assertThat(same.rgb()).containsExactly(1, .5f, .5f);
    }
  }

  @Test
  void exposuresAndCorrectionsAreUndone() throws ImageFormatException {
    Image image = read("EXPOSURE=2;COLORCORR= 1 2 4;EXPOSURE=.25;;-Y 1 +X 1", 128, 128, 128, 129);
    assertThat(image.rgb()).containsExactly(2, 1, .5f);
  }

  /** The file's pixels are 1, 2, 3 in the first line and 4, 5, 6 in the second. */
  @ParameterizedTest
  @CsvSource({
    "-Y 2 +X 3, 123456",
    "-Y 2 -X 3, 321654",
    "+Y 2 +X 3, 456123",
    "+Y 2 -X 3, 654321",
    "+X 2 -Y 3, 142536",
    "+X 2 +Y 3, 362514",
    "-X 2 -Y 3, 415263",
    "-X 2 +Y 3, 635241"
  })
  void allOrientationsAreRead(String resolution, String pixels) throws ImageFormatException {
    int[] data = new int[24];
    for (int i = 0; i < 6; i++) {
      data[4 * i] = i + 1;
      data[4 * i + 3] = 136;
    }
    Image image = read(";" + resolution, data);
    StringBuilder found = new StringBuilder();
    for (int i = 0; i < 6; i++) {
      found.append((int) image.rgb()[3 * i]);
    }
    assertThat(found).hasToString(pixels);
    assertThat(image.width()).isEqualTo(resolution.contains("X 3") ? 3 : 2);
  }

  @Test
  void newRunsAreRead() throws ImageFormatException {
    int[] data = {
      2, 2, 0, 9, // The line.
      137, 5, // A run of red.
      4, 1, 2, 3, 4, 133, 7, // Four values of green, and a run.
      9, 1, 2, 3, 4, 5, 6, 7, 8, 9, 137, 136
    };
    Image image = read(";-Y 1 +X 9", data);
    for (int i = 0; i < 9; i++) {
      assertThat(image.pixel(i, 0)).isEqualTo(new Rgb(5, i < 4 ? i + 1 : 7, i + 1));
    }
  }

  @Test
  void oldRunsAreRead() throws ImageFormatException {
    int[] data = {9, 8, 7, 136, 1, 1, 1, 4, 1, 1, 1, 1, 6, 0, 0, 136};
    Image image = read(";-Y 1 +X 262", data);
    assertThat(image.pixel(260, 0)).isEqualTo(new Rgb(9, 8, 7));
    assertThat(image.pixel(261, 0)).isEqualTo(new Rgb(6, 0, 0));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "FORMAT=32-bit_rle_xyze;;-Y 1 +X 1|line 2: expected the format 32-bit_rle_rgbe, found XYZE",
        "EXPOSURE=0;;-Y 1 +X 1|line 2: expected positive numbers",
        "EXPOSURE=;;-Y 1 +X 1|line 2: expected numbers",
        "COLORCORR=1 2;;-Y 1 +X 1|line 2: expected numbers",
        ";-Y 1 +Y 1|line 3: expected a resolution such as -Y 480 +X 640",
        ";-Y 1|line 3: expected a resolution such as -Y 480 +X 640",
        ";-Y 0 +X 1|the picture has no pixels",
        ";-Y 99999 +X 1|the picture has 1x99999 pixels",
        ";-Y 65535 +X 4000|Radiance HDR ends too early",
        ";-Y 1 +X 5|Radiance HDR ends too early",
        "a|Radiance HDR ends too early"
      })
  void errorsNameTheLine(String header, String message) {
    assertThat(refusal(file(header, 1, 2, 3, 136))).contains(message);
  }

  @Test
  void runsEndWithTheirLine() {
    assertThat(refusal(file(";-Y 1 +X 8", 2, 2, 0, 9, 0, 0))).contains("another length");
    assertThat(refusal(file(";-Y 1 +X 8", 2, 2, 0, 8, 137, 0))).contains("a run is too long");
    assertThat(refusal(file(";-Y 1 +X 8", 2, 2, 0, 8, 0, 0))).contains("a run is too long");
    assertThat(refusal(file(";-Y 1 +X 8", 1, 1, 1, 1, 0, 0))).contains("a run is too long");
    assertThat(refusal(file(";-Y 1 +X 8", 9, 9, 9, 9, 1, 1, 1, 8))).contains("a run is too long");
  }

  @Test
  void everyTruncationIsRefused() {
    byte[] whole = file("A=B;;-Y 1 +X 9", 2, 2, 0, 9, 137, 5, 137, 5, 137, 5, 137, 136);
    assertThat(refusal(whole)).isEqualTo("none");
    for (int length = 0; length < whole.length; length++) {
      byte[] part = Arrays.copyOf(whole, length);
      assertThatThrownBy(() -> LinearReader.decode(part)).isInstanceOf(ImageFormatException.class);
    }
  }
}
