package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code lumbre compare} with invalid pictures, made by hand for each kind of fault. */
class HostilePictureFilesTest {
  private static final int WIDTH = 8;
  private static final int HEIGHT = 20;

  @TempDir private Path directory;
  private String sound;
  private byte[] exr;

  @BeforeEach
  void writeSoundPictures() throws IOException {
    Image image = Image.black(WIDTH, HEIGHT);
    Arrays.fill(image.rgb(), .5f);
    float[] alpha = new float[WIDTH * HEIGHT];
    Arrays.fill(alpha, 1);
    Path pfm = directory.resolve("sound.pfm");
    ImageWriter.write(image, pfm);
    sound = pfm.toString();
    Path file = directory.resolve("sound.exr");
    ImageWriter.write(
        new Image(WIDTH, HEIGHT, image.rgb(), alpha),
        file,
        new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of()));
    exr = Files.readAllBytes(file);
  }

  /** Checks the file as the picture and as the reference, with text and JSON output. */
  private void assertRefused(byte[] content, int exitCode, String reason) throws IOException {
    String file = Files.write(directory.resolve("hostile"), content).toString();
    Outcome.of("compare", file, sound).assertFailed(exitCode, "hostile: ", reason);
    Outcome.of("compare", sound, file, "--json").assertFailed(exitCode, "hostile: ", reason);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "PF 8 20 -1; 4; expected 1920 bytes of pixels, found 0",
        "PF 65535 4096 -1; 4; expected 3221176320 bytes of pixels, found 0",
        "PF 65536 20 -1; 5; 65536x20 pixels",
        "PF 65535 65535 -1; 5; 65535x65535 pixels",
        "PF -8 20 -1; 4; header is damaged",
        "PF 8 -20 -1; 4; header is damaged",
        "PF 0 20 -1; 4; no pixels",
        "PF 8 99999999999 -1; 4; header is damaged",
        "PF 8 20 0; 4; header is damaged",
        "PF 8 20 NaN; 4; header is damaged",
        "PF 8 20 -Infinity; 4; header is damaged",
        "PF 8 20 x; 4; header is damaged",
        "PF 8; 4; header is damaged"
      })
  void headersOfFloatMapsThatLie(String header, int exitCode, String reason) throws IOException {
    assertRefused((header + "\n").getBytes(StandardCharsets.US_ASCII), exitCode, reason);
  }

  /** Returns the OpenEXR file with four bytes of an attribute replaced. */
  private byte[] with(String attribute, int at, int value) {
    byte[] file = exr.clone();
    ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).putInt(start(attribute) + at, value);
    return file;
  }

  /** Returns the OpenEXR file with the first byte of an attribute replaced. */
  private byte[] with(String attribute, int value) {
    byte[] file = exr.clone();
    file[start(attribute)] = (byte) value;
    return file;
  }

  /** Returns the offset of an attribute's value, after its name, its type and its length. */
  private int start(String attribute) {
    int name = new String(exr, StandardCharsets.ISO_8859_1).indexOf(attribute + "\0");
    int type = name + attribute.length() + 1;
    while (exr[type] != 0) {
      type++;
    }
    return type + 1 + Integer.BYTES;
  }

  /** A window is four numbers: the first column and row, the last column and row. */
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "8; 2147483647; 5; pixels, expected at most 65535",
        "8; -2147483648; 4; ends before it begins",
        "0; -2147483648; 5; pixels, expected at most 65535",
        "4; 2147483647; 4; ends before it begins",
        "8; 65535; 5; 65536x20 pixels",
        "8; 65534; 4; ends too early",
        "12; 65534; 4; ends too early",
        "8; 8; 4; damaged",
        "12; 18; 4; damaged",
        "4; 1; 4; damaged"
      })
  void windowsOfOpenExrThatLie(int at, int value, int exitCode, String reason) throws IOException {
    assertRefused(with("dataWindow", at, value), exitCode, reason);
  }

  @Test
  void otherCompressionsAndChannelsOfOpenExr() throws IOException {
    for (int compression : new int[] {10, 11, 12, 255}) {
      assertRefused(
          with("compression", compression), 4, "expected no compression, RLE, ZIPS, ZIP, PIZ,");
    }
    for (int compression : new int[] {1, 4, 5, 6, 7, 8, 9}) {
      assertRefused(with("compression", compression), 4, "OpenEXR");
    }
    assertRefused(with("channels", 2, 1), 4, "damaged");
    assertRefused(with("channels", 2, 3), 4, "expected channels of uint, half or float");
    assertRefused(with("channels", 10, 2), 4, "expected channels without subsampling");
    assertRefused(with("channels", 'G'), 4, "expected different channels");
  }

  @Test
  void blocksOfOpenExrTwice() throws IOException {
    int last = exr.length;
    ByteBuffer in = ByteBuffer.wrap(exr).order(ByteOrder.LITTLE_ENDIAN);
    // The second block holds the last four lines; the number of the first block overwrites its
    // number.
    for (int i = 0; i < last - 8; i++) {
      if (in.getInt(i) == 16 && in.getInt(i + 4) == last - i - 8) {
        in.putInt(i, 0);
      }
    }
    assertRefused(exr, 4, "damaged");
  }

  @Test
  void valuesThatAreNoLight() throws IOException {
    for (float value : new float[] {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY}) {
      byte[] map = Files.readAllBytes(Path.of(sound));
      ByteBuffer.wrap(map).order(ByteOrder.LITTLE_ENDIAN).putFloat(map.length - 4, value);
      assertRefused(map, 4, "has NaN or infinite values");
      assertRefused(uncompressed(1, value), 4, "has NaN or infinite values");
    }
  }

  /** Colors are compared as they are stored. */
  @Test
  void anyAlphaIsIgnored() throws IOException {
    for (float alpha : new float[] {0, 1e-30f, .5f, 1, 1.5f, -1e-30f, Float.NaN}) {
      Path file = Files.write(directory.resolve("alpha"), uncompressed(alpha, .5f));
      assertThat(Outcome.of("compare", file.toString(), sound).out())
          .contains("bias    0.00000 ", "max     0.00000 ");
    }
  }

  /** Returns the OpenEXR file without compression, with the same values everywhere. */
  private byte[] uncompressed(float alpha, float color) {
    ByteBuffer old = ByteBuffer.wrap(exr).order(ByteOrder.LITTLE_ENDIAN);
    int table = 0;
    while (old.getLong(table) != table + 2 * Long.BYTES) {
      table++;
    }
    int bytes = 4 * WIDTH * Float.BYTES;
    ByteBuffer file =
        ByteBuffer.allocate(table + HEIGHT * (2 * Long.BYTES + bytes))
            .order(ByteOrder.LITTLE_ENDIAN)
            .put(with("compression", 0), 0, table)
            .position(table + HEIGHT * Long.BYTES);
    for (int y = 0; y < HEIGHT; y++) {
      file.putInt(y).putInt(bytes);
      for (int i = 0; i < 4 * WIDTH; i++) {
        file.putFloat(i < WIDTH ? alpha : color);
      }
    }
    return file.array();
  }

  @Test
  void largestNumbersAreCompared() throws IOException {
    Image image = Image.black(WIDTH, HEIGHT);
    for (int i = 0; i < image.rgb().length; i++) {
      image.rgb()[i] = i % 2 == 0 ? Float.MAX_VALUE : -Float.MAX_VALUE;
    }
    Path file = directory.resolve("a.pfm");
    ImageWriter.write(image, file);
    assertThat(Outcome.of("compare", file.toString(), sound, "--json").exitCode()).isZero();
    assertThat(Outcome.of("compare", sound, file.toString(), "--json").exitCode()).isZero();
  }
}
