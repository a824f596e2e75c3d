package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.internal.ImageFixture;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.PictureEncoder;
import io.github.lumbre.testing.Folders;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests properties of all picture writers. */
class ImageWriterTest {
  @TempDir Path directory;

  @ParameterizedTest
  @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "SVG")
  void aFullDiskIsReportedWhereverItStrikes(ImageFormat format) throws IOException {
    Image image = ImageFixture.random(40, 40, true);
    Path file = directory.resolve("a" + format.ending());
    int size = ImageFixture.written(image, file, ImageWriter.Options.DEFAULT).length;
    for (int room = 0; room < size; room += Math.max(1, size / 50)) {
      FullChannel channel = new FullChannel(room);
      assertThatThrownBy(() -> format.write(image, List.of(), ImageWriter.Options.DEFAULT, channel))
          .isInstanceOf(IOException.class)
          .hasMessage("No space left on device");
    }
  }

  @Test
  void anExistingFileIsKeptWhenWritingFails() throws IOException {
    Path file = Files.writeString(directory.resolve("a.png"), "old");
    assertThatThrownBy(() -> ImageWriter.write(Image.black(1, 1), file, null))
        .isInstanceOf(NullPointerException.class);
    assertThat(file).hasContent("old");
    assertThat(Folders.files(directory)).containsExactly(file);
  }

  @Test
  void aReservedFileIsWrittenAndCommitted() throws IOException {
    Path file = directory.resolve("a.pfm");
    try (OutputFile output = OutputFile.open(file)) {
      PictureEncoder.write(Image.black(1, 1), List.of(), output, ImageWriter.Options.DEFAULT);
      assertThat(file).hasSize("PF\n1 1\n-1.0\n".length() + 12);
    }
  }

  @Test
  void anUnknownEndingIsRefusedBeforeAnythingIsCreated() throws IOException {
    Path file = directory.resolve("a.gif");
    assertThatThrownBy(() -> ImageWriter.write(Image.black(1, 1), file))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(file + ": expected a name that ends in one of .png, .pfm, .exr, .jpg, .jpeg");
    assertThat(directory).isEmptyDirectory();
  }

  private static byte[] bytes(Image image, ImageFormat format, ImageWriter.Options options) {
    return switch (format) {
      case PNG -> image.toPng(options);
      case PFM -> image.toPfm();
      case EXR -> image.toExr(options);
      case JPG -> image.toJpeg(options);
      case SVG -> throw new IllegalArgumentException("no pixels");
    };
  }

  @ParameterizedTest
  @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "SVG")
  void aPictureHasTheBytesOfItsFile(ImageFormat format) throws IOException {
    Image image = ImageFixture.random(70, 133, true);
    ImageWriter.Options options =
        new ImageWriter.Options(Exposure.of(1), ToneCurve.ACES, 16, Map.of("Title", "a"));
    Path file = directory.resolve("a" + format.ending());
    byte[] expected = ImageFixture.written(image, file, options);
    assertThat(bytes(image, format, options)).isEqualTo(expected);
  }

  @Test
  void aJpegThatIsTooWideIsRefused() {
    Image wide = Image.black(ImageWriter.MAX_JPEG_SIDE + 1, 1);
    assertThatThrownBy(() -> wide.toJpeg(ImageWriter.Options.DEFAULT))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("Image of 65501x1 pixels: ");
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aBufferedImageHasThePixelsOfThePng(boolean hasAlpha) throws IOException {
    Image image = ImageFixture.random(17, 33, hasAlpha);
    ImageWriter.Options options =
        new ImageWriter.Options(Exposure.of(1), ToneCurve.ACES, 8, Map.of());
    BufferedImage shown = image.toBufferedImage(options);
    BufferedImage png = ImageIO.read(new ByteArrayInputStream(image.toPng(options)));
    assertThat(shown.getColorModel().hasAlpha()).isEqualTo(hasAlpha);
    for (int y = 0; y < 33; y++) {
      for (int x = 0; x < 17; x++) {
        assertThat(shown.getRGB(x, y)).isEqualTo(png.getRGB(x, y));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "SVG")
  void theSamePictureGivesTheSameBytes(ImageFormat format) throws IOException {
    Image image = ImageFixture.random(17, 33, true);
    Path file = directory.resolve("a" + format.ending());
    byte[] first = ImageFixture.written(image, file, ImageWriter.Options.DEFAULT);
    assertThat(ImageFixture.written(image, file, ImageWriter.Options.DEFAULT)).isEqualTo(first);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " a", "a ", "a  b", "a\nb", "ü", "channels", "dataWindow"})
  void aKeywordThatSomeFormatCannotHoldIsRefused(String keyword) {
    assertRefused(Map.of(keyword, "text"));
  }

  @Test
  void aKeywordHasAtMost79Characters() {
    assertRefused(Map.of("k".repeat(80), "text"));
    assertThat(
            new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of("k".repeat(79), ""))
                .metadata())
        .hasSize(1);
  }

  private static void assertRefused(Map<String, String> metadata) {
    assertThatThrownBy(() -> new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, metadata))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("metadata: ");
  }

  @Test
  void optionsAreImmutable() {
    Map<String, String> metadata = new HashMap<>(Map.of("Seed", "1"));
    ImageWriter.Options options =
        new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, metadata);
    metadata.put("Seed", "2");
    assertThat(options.metadata()).containsExactly(Map.entry("Seed", "1"));
    assertThatThrownBy(() -> options.metadata().clear())
        .isInstanceOf(UnsupportedOperationException.class);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 7, 12, 32})
  void bitsAreEightOrSixteen(int bits) {
    assertThatThrownBy(() -> ImageFixture.options(ToneCurve.SRGB, bits))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("pngBits: expected 8 or 16, found " + bits);
  }

  /** A channel on a device with little free space. */
  private static final class FullChannel implements SeekableByteChannel {
    private final int room;
    private long position;

    FullChannel(int room) {
      this.room = room;
    }

    @Override
    public int write(ByteBuffer source) throws IOException {
      if (position + source.remaining() > room) {
        throw new IOException("No space left on device");
      }
      int count = source.remaining();
      source.position(source.limit());
      position += count;
      return count;
    }

    @Override
    public int read(ByteBuffer destination) {
      throw new AssertionError("never read");
    }

    @Override
    public long position() {
      return position;
    }

    @Override
    public SeekableByteChannel position(long next) {
      position = next;
      return this;
    }

    @Override
    public long size() {
      return position;
    }

    @Override
    public SeekableByteChannel truncate(long size) {
      throw new AssertionError("never truncated");
    }

    @Override
    public boolean isOpen() {
      return true;
    }

    @Override
    public void close() {
      throw new AssertionError("the caller's to close");
    }
  }

  @Test
  void arraysHaveTheLengthOfThePicture() {
    for (int length : new int[] {0, 17, 19}) {
      assertThatThrownBy(() -> new Image(2, 3, new float[length], new float[0]))
          .hasMessage("rgb: expected 18 values, found " + length);
    }
    for (int length : new int[] {1, 5, 7}) {
      assertThatThrownBy(() -> new Image(2, 3, new float[18], new float[length]))
          .hasMessage("alpha: expected 0 or 6 values, found " + length);
    }
  }

  @Test
  void everyPrintableCharacterIsForKeywords() {
    for (String keyword : new String[] {"a b", "~", "!"}) {
      Map<String, String> metadata = Map.of(keyword, "text");
      assertThat(new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, metadata).metadata())
          .isEqualTo(metadata);
    }
  }
}
