package io.github.lumbre.image.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ImageFixture;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.LinearReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests files in the form of other programs, derived from those of {@link ExrWriter}. */
class ExrReaderTest {
  @TempDir private Path directory;

  /** An OpenEXR file in parts: its header, and blocks that each start with their first line. */
  private final class Parts {
    private final Image image;
    private final byte[] header;
    private final List<byte[]> blocks = new ArrayList<>();

    /**
     * @param lines the lines per block; the blocks are not compressed
     */
    Parts(Image image, int compression, int lines) throws IOException {
      this.image = image;
      byte[] file =
          ImageFixture.written(image, directory.resolve("a.exr"), ImageWriter.Options.DEFAULT);
      int offsets = 8 * ((image.height() + 15) / 16);
      int first = (int) little(file).getLong(headerEnd(file));
      header = Arrays.copyOf(file, first - offsets);
      header[valueOf("compression")] = (byte) compression;
      for (int y = 0; y < image.height(); y += lines) {
        blocks.add(block(y, Math.min(lines, image.height() - y)));
      }
    }

    private int headerEnd(byte[] file) {
      int at = indexOf(file, "screenWindowWidth") + "screenWindowWidth\0float\0".length();
      return at + 4 + 4 + 1;
    }

    private int valueOf(String attribute) {
      int type = indexOf(header, attribute) + attribute.length() + 1;
      int end = type;
      while (header[end] != 0) {
        end++;
      }
      return end + 1 + 4;
    }

    private byte[] block(int first, int lines) {
      int channels = image.hasAlpha() ? 4 : 3;
      int bytes = 4 * channels * image.width() * lines;
      ByteBuffer block = ByteBuffer.allocate(8 + bytes).order(ByteOrder.LITTLE_ENDIAN);
      block.putInt(first).putInt(bytes);
      for (int y = first; y < first + lines; y++) {
        for (int x = 0; x < image.width() && image.hasAlpha(); x++) {
          block.putFloat(image.alpha(x, y));
        }
        for (int component = 2; component >= 0; component--) {
          for (int x = 0; x < image.width(); x++) {
            float value = image.rgb()[3 * (y * image.width() + x) + component];
            block.putFloat(value * image.alpha(x, y));
          }
        }
      }
      return block.array();
    }

    /** Moves both windows to another position in the plane. */
    Parts at(int x, int y) {
      for (String name : new String[] {"dataWindow", "displayWindow"}) {
        ByteBuffer window = little(header).position(valueOf(name));
        window.putInt(x).putInt(y).putInt(x + image.width() - 1).putInt(y + image.height() - 1);
      }
      blocks.forEach(block -> little(block).putInt(0, little(block).getInt(0) + y));
      return this;
    }

    byte[] file() {
      ByteArrayOutputStream file = new ByteArrayOutputStream();
      file.writeBytes(header);
      file.writeBytes(new byte[8 * blocks.size()]);
      blocks.forEach(file::writeBytes);
      return file.toByteArray();
    }
  }

  private static int indexOf(byte[] file, String text) {
    return new String(file, StandardCharsets.ISO_8859_1).indexOf(text + "\0");
  }

  private static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static void assertRefused(byte[] file, String message) {
    assertThatThrownBy(() -> LinearReader.decode(file))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageContaining(message);
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "2, 1", "3, 16"})
  void blocksThatAreNotCompressedAreRead(int compression, int lines) throws IOException {
    for (int height : new int[] {1, 15, 16, 17, 40}) {
      Image image = ImageFixture.random(5, height, false);
      Image read = LinearReader.decode(new Parts(image, compression, lines).file());
      assertThat(read.rgb()).isEqualTo(image.rgb());
      assertThat(read.height()).isEqualTo(height);
    }
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "7, 3", "-5, -1000", "100000, 65536"})
  void windowsLieAnywhere(int x, int y) throws IOException {
    Image image = ImageFixture.random(6, 35, false);
    assertThat(LinearReader.decode(new Parts(image, 3, 16).at(x, y).file()).rgb())
        .isEqualTo(image.rgb());
  }

  @Test
  void blocksComeInAnyOrder() throws IOException {
    Image image = ImageFixture.random(6, 35, false);
    Parts parts = new Parts(image, 3, 16);
    Collections.reverse(parts.blocks);
    assertThat(LinearReader.decode(parts.file()).rgb()).isEqualTo(image.rgb());
  }

  @Test
  void eachBlockComesOnceAndWhereItBelongs() throws IOException {
    Image image = ImageFixture.random(6, 32, false);
    Parts twice = new Parts(image, 3, 16);
    twice.blocks.set(1, twice.blocks.get(0));
    assertRefused(twice.file(), "one block for every 16 lines");
    Parts moved = new Parts(image, 3, 16);
    little(moved.blocks.get(1)).putInt(0, 15);
    assertRefused(moved.file(), "one block for every 16 lines");
    Parts outside = new Parts(image, 3, 16);
    little(outside.blocks.get(1)).putInt(0, 32);
    assertRefused(outside.file(), "damaged or ends too early");
  }

  @ParameterizedTest
  @ValueSource(ints = {-4, 4})
  void linesHaveTheBytesOfTheirPixels(int more) throws IOException {
    Parts parts = new Parts(ImageFixture.random(6, 2, false), 0, 1);
    byte[] block = parts.blocks.get(0);
    little(block).putInt(4, block.length - 8 + more);
    parts.blocks.set(0, Arrays.copyOf(block, block.length + more));
    assertRefused(parts.file(), "too short or too long");
  }

  @Test
  void missingBlocksAreNoticed() throws IOException {
    Parts parts = new Parts(ImageFixture.random(6, 33, false), 3, 16);
    byte[] file = parts.file();
    int last = parts.blocks.get(2).length;
    assertRefused(Arrays.copyOf(file, file.length - last), "damaged or ends too early");
    assertRefused(Arrays.copyOf(file, parts.header.length + 8 * 3 - 1), "ends too early");
  }

  @Test
  void windowsBeyondTheLimitsAreRefusedByTheHeader() throws IOException {
    Parts parts = new Parts(ImageFixture.random(1, 1, false), 3, 16);
    ByteBuffer header = little(parts.header);
    int window = parts.valueOf("dataWindow");
    header.putInt(window + 8, 65534);
    assertRefused(parts.file(), "OpenEXR ends too early");
    int shown = parts.valueOf("displayWindow");
    header.putInt(window + 8, 0).putInt(shown, 65535 - (1 << 17));
    assertRefused(parts.file(), "the picture has 65538x1 pixels");
    header.putInt(shown, 0).putInt(shown + 8, 65534).putInt(shown + 12, 65534);
    assertRefused(parts.file(), "the picture has 65535x65535 pixels");
    assertThatThrownBy(() -> LayeredImage.of(parts.file()))
        .hasMessageContaining("the picture has 65535x65535 pixels");
    header.putInt(shown + 12, 0);
    assertThatThrownBy(() -> ImageFormat.read(parts.file(), 65534))
        .hasMessage("the picture has 65535x1 pixels, expected at most 65534 in total");
    header.putInt(shown, 1).putInt(shown + 8, 0);
    assertRefused(parts.file(), "the display window ends before it begins");
    header.putInt(shown, 0);
    header.putInt(window + 8, 65535);
    assertRefused(parts.file(), "the picture has 65536x1 pixels");
    header.putInt(window, Integer.MIN_VALUE).putInt(window + 8, Integer.MAX_VALUE);
    assertRefused(parts.file(), "the picture has 2147483647x1 pixels");
    header.putInt(window, 1).putInt(window + 8, 0);
    assertRefused(parts.file(), "the data window ends before it begins");
  }

  @Test
  void unsupportedKindsAreRefused() throws IOException {
    Image image = ImageFixture.random(2, 2, false);
    for (int word = 0; word < 4; word++) {
      Parts parts = new Parts(image, 3, 16);
      // After the name: type, linearity, and the sampling in x and y.
      int at = parts.valueOf("channels") + 2 + 4 * word;
      little(parts.header).putInt(at, little(parts.header).getInt(at) + 1);
      if (word == 1) {
        assertThat(LinearReader.decode(parts.file()).rgb()).isEqualTo(image.rgb());
      } else {
        assertRefused(
            parts.file(),
            word == 0
                ? "expected channels of uint, half or float, found type 3"
                : "expected channels without subsampling, found one that has a value for every "
                    + (word == 2 ? "2 columns and 1 lines" : "1 columns and 2 lines"));
      }
    }
    Parts twice = new Parts(image, 3, 16);
    twice.header[twice.valueOf("channels")] = 'G';
    assertRefused(twice.file(), "expected different channels");
    Parts version = new Parts(image, 3, 16);
    version.header[4] = 1;
    assertRefused(version.file(), "expected version 2, found version and flags 0x1");
  }

  @Test
  void emptyTextsAreAttributesToo() throws IOException {
    Image image = ImageFixture.random(3, 3, false);
    ImageWriter.Options options =
        new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of("Empty", ""));
    byte[] file = ImageFixture.written(image, directory.resolve("b.exr"), options);
    assertThat(LinearReader.decode(file).rgb()).isEqualTo(image.rgb());
  }

  @Test
  void attributesEndInTheFile() throws IOException {
    Parts parts = new Parts(ImageFixture.random(1, 1, false), 3, 16);
    int length = parts.valueOf("screenWindowWidth") - 4;
    for (int claimed : new int[] {-1, Integer.MIN_VALUE, Integer.MAX_VALUE}) {
      little(parts.header).putInt(length, claimed);
      assertRefused(parts.file(), "OpenEXR ends too early");
    }
  }

  /** Tests highly compressible blocks, in which few bytes encode many pixels. */
  @Test
  void evenPicturesAreReadHoweverFewTheirBytes() throws IOException {
    Image even = Image.black(3000, 33);
    byte[] file =
        ImageFixture.written(even, directory.resolve("c.exr"), ImageWriter.Options.DEFAULT);
    assertThat(file).hasSizeLessThan(3000 * 33 * 12 / 200);
    assertThat(LinearReader.decode(file).rgb()).isEqualTo(even.rgb());
  }

  @Test
  void magicNumberAloneIsNoPicture() {
    byte[] eight = {0x76, 0x2f, 0x31, 1, 2, 0, 0, 0};
    assertRefused(eight, "OpenEXR is damaged or ends too early");
    assertRefused(Arrays.copyOf(eight, 7), "found none of them");
  }

  /**
   * With 400x48 pixels in three blocks of 8 bytes, each byte claims more than 1000 bytes of pixels.
   */
  @Test
  void claimsOfManyPixelsOverFewBytesTakeNoMemory() throws IOException {
    Parts parts = new Parts(ImageFixture.random(400, 48, false), 3, 16);
    for (byte[] block : List.copyOf(parts.blocks)) {
      byte[] few = Arrays.copyOf(block, 16);
      little(few).putInt(4, 8);
      parts.blocks.set(parts.blocks.indexOf(block), few);
    }
    assertRefused(parts.file(), "OpenEXR ends too early");
  }
}
