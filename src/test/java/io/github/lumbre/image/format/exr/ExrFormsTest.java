package io.github.lumbre.image.format.exr;

import static io.github.lumbre.testing.Near.assertNear;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.testing.SampleFiles;
import java.io.IOException;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests OpenEXR files of all supported compressions, layouts, channels and number types. */
class ExrFormsTest {
  private static final int UINT = 0;
  private static final int HALF = 1;
  private static final int FLOAT = 2;

  private static double value(int x, int y) {
    return x < 20 ? x / 3.0 + y : 7;
  }

  private static void assertValues(Image image, int width, int height) {
    assertThat(image.width()).isEqualTo(width);
    assertThat(image.height()).isEqualTo(height);
    for (int i = 0; i < 3 * width * height; i++) {
      float expected = (float) ((1 << i % 3) * value(i / 3 % width, i / 3 / width));
      assertThat(image.rgb()[i]).isEqualTo(expected);
    }
  }

  private static void assertRefused(byte[] file, String message) {
    assertThatThrownBy(() -> LinearReader.decode(file))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageContaining(message);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void scanLinesAreRead(int compression) throws ImageFormatException {
    for (int height : new int[] {1, 16, 35}) {
      byte[] file = new ExrBuilder(90, height, compression).rgb("", ExrFormsTest::value).file();
      assertValues(LinearReader.decode(file), 90, height);
    }
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "1, 0", "3, 0", "0, 1", "3, 1", "3, 17"})
  void fullSizeLevelOfTilesIsRead(int compression, int levels) throws ImageFormatException {
    byte[] file =
        new ExrBuilder(45, 34, compression)
            .rgb("", ExrFormsTest::value)
            .tiles(16, 8, levels)
            .file();
    assertValues(LinearReader.decode(file), 45, 34);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 16})
  void firstPartIsRead(int tile) throws ImageFormatException {
    ExrBuilder first = new ExrBuilder(45, 34, 3).rgb("", ExrFormsTest::value);
    ExrBuilder second = new ExrBuilder(7, 9, 3).rgb("", (x, y) -> -1);
    if (tile > 0) {
      first.tiles(tile, tile, 0);
      second.tiles(tile, tile, 0);
    }
    assertValues(LinearReader.decode(first.fileBefore(second)), 45, 34);
  }

  @Test
  void numbersHaveThreeTypes() throws ImageFormatException {
    byte[] file =
        new ExrBuilder(5, 3, 0)
            .channel("R", UINT, (x, y) -> x == 4 ? 0xffffffffL : x)
            .channel("G", HALF, (x, y) -> x == 4 ? 0 : -Math.scalb(1, x - y))
            .channel("B", FLOAT, (x, y) -> x + .1)
            .channel("Z", FLOAT, (x, y) -> 1e30)
            .file();
    Image image = LinearReader.decode(file);
    assertThat(image.pixel(1, 2)).isEqualTo(new Rgb(1, -.5, 1.1f));
    assertThat(image.pixel(4, 0)).isEqualTo(new Rgb(4294967296.0, 0, 4.1f));
  }

  @Test
  void halvesCoverAllKindsOfNumbers() {
    assertThat(ExrChannel.ofHalf((short) 0x3c00)).isEqualTo(1);
    assertThat(ExrChannel.ofHalf((short) 0xc001)).isEqualTo(-2 - 0x1p-9f);
    assertThat(ExrChannel.ofHalf((short) 0x7bff)).isEqualTo(65504);
    assertThat(ExrChannel.ofHalf((short) 0x0001)).isEqualTo(0x1p-24f);
    assertThat(ExrChannel.ofHalf((short) 0x03ff)).isEqualTo(1023 * 0x1p-24f);
    assertThat(ExrChannel.ofHalf((short) 0x0400)).isEqualTo(0x1p-14f);
    assertThat(ExrChannel.ofHalf((short) 0x8000)).isEqualTo(-0f);
    assertThat(ExrChannel.ofHalf((short) 0x7c00)).isEqualTo(Float.POSITIVE_INFINITY);
    assertThat(ExrChannel.ofHalf((short) 0xfc00)).isEqualTo(Float.NEGATIVE_INFINITY);
    assertThat(ExrChannel.ofHalf((short) 0x7e00)).isNaN();
  }

  @Test
  void grayAndOneLayerArePictures() throws ImageFormatException {
    ExrBuilder gray = new ExrBuilder(4, 2, 0).channel("Y", FLOAT, (x, y) -> x);
    assertThat(LinearReader.decode(gray.file()).pixel(3, 1)).isEqualTo(Rgb.gray(3));
    gray.channel("A", HALF, (x, y) -> .5);
    assertThat(LinearReader.decode(gray.file()).pixel(3, 1)).isEqualTo(Rgb.gray(6));
    ExrBuilder layer = new ExrBuilder(45, 2, 0).rgb("a.b.", ExrFormsTest::value);
    layer.channel("depth.Z", FLOAT, (x, y) -> 0).channel("R", FLOAT, (x, y) -> 0);
    assertValues(LinearReader.decode(layer.file()), 45, 2);
  }

  private static Rgb converted(double r, double g, double b, double... xy)
      throws ImageFormatException {
    ExrBuilder file =
        new ExrBuilder(3, 2, 3)
            .channel("R", FLOAT, (x, y) -> r)
            .channel("G", FLOAT, (x, y) -> g)
            .channel("B", FLOAT, (x, y) -> b);
    return LinearReader.decode(file.chromaticities(xy).file()).pixel(2, 1);
  }

  /** The matrices are those of ITU-R BT.2087, SMPTE EG 432-1 and ACES (S-2014-004). */
  @Test
  void colorsOfOtherPrimariesAreConverted() throws ImageFormatException {
    double[] bt2020 = {.708, .292, .17, .797, .131, .046, .3127, .329};
    assertNear(converted(.5, .1, .1, bt2020), new Rgb(.7643, .0502, .0928), 1e-3);
    assertNear(converted(0, 1, 0, bt2020), new Rgb(-.5876, 1.1329, -.1006), 1e-3);
    double[] displayP3 = {.68, .32, .265, .69, .15, .06, .3127, .329};
    assertNear(converted(1, 0, 0, displayP3), new Rgb(1.2249, -.0420, -.0196), 1e-3);
    double[] acesCg = {.713, .293, .165, .83, .128, .044, .32168, .33767};
    assertNear(converted(1, 0, 0, acesCg), new Rgb(1.7051, -.1303, -.0240), 1e-3);
    double[] aces = {.7347, .2653, 0, 1, .0001, -.077, .32168, .33767};
    assertNear(converted(1, 1, 1, aces), new Rgb(1, 1, 1), 1e-3);
    assertNear(converted(1, 0, 0, aces), new Rgb(2.5216, -.2765, -.0154), 1e-3);
  }

  /** Named layers need not be colors of light. */
  @Test
  void colorsOfThePictureAmongLayersAreConverted() throws ImageFormatException {
    ExrBuilder file =
        new ExrBuilder(3, 2, 0)
            .rgb("", (x, y) -> x)
            .channel("A", FLOAT, (x, y) -> .25)
            .rgb("normal.", (x, y) -> 1)
            .chromaticities(.708, .292, .17, .797, .131, .046, .3127, .329);
    LayeredImage image = LayeredImage.of(file.file());
    ImageLayer picture = image.layer("").orElseThrow();
    Rgb expected = LinearReader.decode(file.file()).pixel(2, 1).times(.25);
    assertThat(picture.value(2, 1, 0)).isEqualTo((float) expected.r());
    assertThat(picture.value(2, 1, 1)).isEqualTo((float) expected.g());
    assertThat(picture.value(2, 1, 3)).isEqualTo(.25f);
    assertThat(image.layer("normal").orElseThrow().value(2, 1, 1)).isEqualTo(2);
  }

  @Test
  void colorsOfBt709AndGrayStay() throws ImageFormatException {
    float value = (float) .1;
    double[] rounded = {.64, .33, .3, .6, .15, .06, .3127, .329};
    assertThat(converted(value, .5, 2, rounded)).isEqualTo(new Rgb(value, .5, 2));
    assertThat(converted(value, .5, 2, new double[8])).isEqualTo(new Rgb(value, .5, 2));
    assertThat(converted(value, .5, 2, 1, 2)).isEqualTo(new Rgb(value, .5, 2));
    ExrBuilder gray = new ExrBuilder(4, 2, 0).channel("Y", FLOAT, (x, y) -> x);
    gray.chromaticities(.708, .292, .17, .797, .131, .046, .3127, .329);
    assertThat(LinearReader.decode(gray.file()).pixel(3, 1)).isEqualTo(Rgb.gray(3));
  }

  @Test
  void otherChannelsAreRefused() {
    ExrBuilder layers = new ExrBuilder(4, 2, 0).rgb("a.", (x, y) -> 0).rgb("b.", (x, y) -> 0);
    assertRefused(layers.file(), "expected one layer of colors, found 2");
    ExrBuilder depth = new ExrBuilder(4, 2, 0).channel("Z", FLOAT, (x, y) -> 0);
    depth.channel("id", UINT, (x, y) -> 0);
    assertRefused(depth.file(), "R, G and B, or one gray channel, found 2 channels");
    ExrBuilder chroma = new ExrBuilder(4, 2, 0).channel("Y", FLOAT, (x, y) -> 0);
    chroma.channel("RY", FLOAT, (x, y) -> 0).channel("BY", FLOAT, (x, y) -> 0);
    assertRefused(chroma.file(), "found luminance and chroma (Y, RY, BY); save the picture as RGB");
  }

  @ParameterizedTest
  @ValueSource(strings = {"R", "Y", "Z", "A", "height", "disp.V", "depth.Z"})
  void oneChannelIsGray(String name) throws ImageFormatException {
    ExrBuilder gray = new ExrBuilder(4, 2, 3).channel(name, FLOAT, (x, y) -> x + y);
    Image image = LinearReader.decode(gray.file());
    assertThat(image.pixel(3, 1)).isEqualTo(Rgb.gray(4));
    assertThat(image.hasAlpha()).isFalse();
    String alpha = name.substring(0, name.lastIndexOf('.') + 1) + "A";
    if (!name.equals("A")) {
      gray.channel(alpha, HALF, (x, y) -> .5);
      assertThat(LinearReader.decode(gray.file()).pixel(3, 1)).isEqualTo(Rgb.gray(8));
    }
  }

  @ParameterizedTest
  @CsvSource({"10, HTJ2K256", "11, HTJ2K32", "12, code 12", "-1, code -1"})
  void otherCompressionsAreRefused(int code, String name) {
    assertRefused(
        new ExrBuilder(4, 2, code).rgb("", (x, y) -> 0).file(),
        "expected no compression, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA or DWAB, found "
            + name);
  }

  @Test
  void deepPicturesAreRefused() {
    byte[] deep = new ExrBuilder(4, 2, 0).rgb("", (x, y) -> 0).file();
    deep[5] = 8;
    assertRefused(deep, "expected version 2, found deep pixels; save the picture flattened");
  }

  /** The file was written by OpenEXR from these formulas. */
  @Test
  void pizWithFewValuesIsRead() throws IOException {
    Image image = LinearReader.decode(SampleFiles.bytes(ExrFormsTest.class, "piz.exr"));
    assertThat(image.width()).isEqualTo(37);
    assertThat(image.height()).isEqualTo(45);
    for (int y = 0; y < 45; y++) {
      for (int x = 0; x < 37; x++) {
        double scale = x < 30 ? 1 : 2;
        Rgb expected = new Rgb(x / 64.0, y / 64.0, (7 * x + 13 * y) % 32 / 32.0).times(scale);
        assertThat(image.pixel(x, y)).isEqualTo(expected);
        assertThat(image.alpha(x, y)).isEqualTo((float) (1 / scale));
      }
    }
  }

  /** The file has halves of all patterns from 1 to 16896: too many for the 14-bit wavelet. */
  @Test
  void pizWithManyValuesIsRead() throws IOException {
    Image image = LinearReader.decode(SampleFiles.bytes(ExrFormsTest.class, "piz-values.exr"));
    assertThat(image.rgb()).hasSize(3 * 512 * 33);
    for (int i = 0; i < 512 * 33; i++) {
      assertThat(image.rgb()[3 * i]).isEqualTo(ExrChannel.ofHalf((short) (i + 1)));
    }
  }

  @Test
  void everyTruncationIsRefused() throws IOException {
    byte[][] files = {
      SampleFiles.bytes(ExrFormsTest.class, "piz.exr"),
      new ExrBuilder(9, 5, 1).rgb("", ExrFormsTest::value).file(),
      new ExrBuilder(9, 5, 3).rgb("", ExrFormsTest::value).tiles(4, 4, 1).file(),
      new ExrBuilder(9, 5, 3)
          .rgb("", ExrFormsTest::value)
          .fileBefore(new ExrBuilder(3, 3, 0).rgb("", (x, y) -> 0))
    };
    for (byte[] file : files) {
      for (int length = 0; length < file.length; length += length < 600 ? 1 : 61) {
        byte[] part = Arrays.copyOf(file, length);
        assertThatThrownBy(() -> LinearReader.decode(part))
            .isInstanceOf(ImageFormatException.class);
      }
    }
  }

  @Test
  void tilesOccurOnceAndInThePicture() {
    ExrBuilder builder = new ExrBuilder(8, 4, 0).rgb("", (x, y) -> 1).tiles(4, 4, 0);
    byte[] twice = builder.file();
    int second = twice.length - (20 + 4 * 4 * 4 * 3);
    twice[second] = 0;
    assertRefused(twice, "a tile occurs twice");
    byte[] outside = builder.file();
    outside[second] = 2;
    assertRefused(outside, "damaged or ends too early");
    byte[] otherLevel = builder.file();
    otherLevel[second + 8] = 1;
    assertRefused(otherLevel, "blocks are missing");
  }
}
