package io.github.lumbre.image.format.png;

import static io.github.lumbre.testing.Pictures.assertSame;
import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.animation.AnimationFixture;
import io.github.lumbre.image.animation.AnimationFrames;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests animated PNG files chunk by chunk. */
class ApngWriterTest {
  @TempDir private Path folder;

  /** A chunk whose checksum is right. */
  private record Chunk(String type, byte[] data) {
    ByteBuffer buffer() {
      return ByteBuffer.wrap(data);
    }
  }

  private static byte[] written(AnimationFrames frames) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ApngWriter.write(frames, Map.of("Comment", "one / two"), out);
    return out.toByteArray();
  }

  private static List<Chunk> chunks(byte[] file) {
    List<Chunk> chunks = new ArrayList<>();
    ByteBuffer in = ByteBuffer.wrap(file).position(8);
    while (in.hasRemaining()) {
      byte[] data = new byte[in.getInt()];
      byte[] type = new byte[4];
      in.get(type).get(data);
      CRC32 crc = new CRC32();
      crc.update(type);
      crc.update(data);
      assertThat(in.getInt()).isEqualTo((int) crc.getValue());
      chunks.add(new Chunk(new String(type, StandardCharsets.US_ASCII), data));
    }
    return chunks;
  }

  /** Returns the frames, decoded as single pictures, and checks the numbers of the sequence. */
  private static List<Pixels> decoded(List<Chunk> chunks) throws IOException {
    List<PngFixture> pictures = new ArrayList<>();
    int sequence = 0;
    for (Chunk chunk : chunks) {
      boolean isControl = chunk.type.equals("fcTL");
      if (isControl) {
        pictures.add(new PngFixture().chunk("IHDR", chunks.get(0).data));
      }
      if (isControl || chunk.type.equals("fdAT")) {
        assertThat(chunk.buffer().getInt()).isEqualTo(sequence++);
      }
      if (chunk.type.equals("IDAT")) {
        assertThat(pictures).hasSize(1);
        pictures.get(0).chunk("IDAT", chunk.data);
      }
      if (chunk.type.equals("fdAT")) {
        assertThat(pictures.size()).isGreaterThan(1);
        byte[] data = Arrays.copyOfRange(chunk.data, 4, chunk.data.length);
        pictures.get(pictures.size() - 1).chunk("IDAT", data);
      }
    }
    List<Pixels> decoded = new ArrayList<>();
    for (PngFixture picture : pictures) {
      decoded.add(ImageReader.decode(picture.end()));
    }
    return decoded;
  }

  private static Pixels random(int width, int height, int channels, int bits, int seed) {
    Random random = new Random(seed);
    int count = width * height * channels;
    if (bits == 8) {
      byte[] values = new byte[count];
      random.nextBytes(values);
      return Pixels.of(width, height, channels, values);
    }
    short[] values = new short[count];
    for (int i = 0; i < count; i++) {
      values[i] = (short) random.nextInt();
    }
    return Pixels.of(width, height, channels, values);
  }

  /** 130 x 130 random pixels have several chunks of data each. */
  @ParameterizedTest
  @CsvSource({"1, 1, 3, 8", "5, 3, 4, 8", "5, 3, 3, 16", "130, 130, 4, 16"})
  void framesAreKeptAsTheyAre(int width, int height, int channels, int bits) throws IOException {
    Pixels[] pictures = new Pixels[3];
    for (int i = 0; i < pictures.length; i++) {
      pictures[i] = random(width, height, channels, bits, i);
    }
    byte[] file = written(AnimationFixture.frames(folder, "30000/1001", pictures));
    List<Chunk> chunks = chunks(file);
    assertThat(chunks.stream().map(Chunk::type).distinct())
        .containsExactly("IHDR", "acTL", "tEXt", "fcTL", "IDAT", "fdAT", "IEND");
    assertThat(chunks.get(1).data).containsExactly(0, 0, 0, 3, 0, 0, 0, 0);
    assertThat(chunks.get(2).data)
        .isEqualTo("Comment\0one / two".getBytes(StandardCharsets.ISO_8859_1));
    List<Pixels> decoded = decoded(chunks);
    assertThat(decoded).hasSize(3);
    for (int i = 0; i < pictures.length; i++) {
      assertSame(decoded.get(i), pictures[i]);
    }
    // What knows no animations shows the first frame.
    assertSame(ImageReader.decode(file), pictures[0]);
    assertThat(ImageIO.read(new ByteArrayInputStream(file)).getWidth()).isEqualTo(width);
  }

  @Test
  void timesAreExactFractions() throws IOException {
    Pixels picture = random(7, 5, 3, 8, 1);
    byte[] file = written(AnimationFixture.frames(folder, "30000/1001", picture, picture));
    for (Chunk chunk : chunks(file)) {
      if (chunk.type.equals("fcTL")) {
        ByteBuffer control = chunk.buffer().position(4);
        assertThat(new int[] {control.getInt(), control.getInt()}).containsExactly(7, 5);
        assertThat(new int[] {control.getInt(), control.getInt()}).containsExactly(0, 0);
        assertThat(control.getShort() & 0xffff).isEqualTo(1001);
        assertThat(control.getShort() & 0xffff).isEqualTo(30000);
        // No disposal, no blending.
        assertThat(control.getShort()).isZero();
        assertThat(control.hasRemaining()).isFalse();
      }
    }
  }

  @Test
  void theColorSpaceOfTheFirstFrameIsKept() throws IOException {
    PngFixture png = new PngFixture().header(1, 1, 8, PngFixture.RGB, false);
    png.chunk("sRGB", new byte[1]).chunk("gAMA", new byte[] {0, 0, (byte) 0xb1, (byte) 0x8f});
    png.chunk("tEXt", "Old\0text".getBytes(StandardCharsets.ISO_8859_1));
    png.data(1, 1, 8, PngFixture.RGB, false, (i, y) -> 9);
    AnimationFrames frames = AnimationFixture.frames(folder, "25", random(1, 1, 3, 8, 1));
    Files.write(frames.files().get(0), png.end());
    assertThat(chunks(written(frames)).stream().map(Chunk::type))
        .containsExactly("IHDR", "acTL", "sRGB", "gAMA", "tEXt", "fcTL", "IDAT", "IEND");
  }

  @Test
  void framesOfAnotherKindAreRefused() throws IOException {
    Pixels opaque = random(2, 2, 3, 8, 1);
    for (Pixels other : List.of(random(2, 2, 4, 8, 1), random(2, 2, 3, 16, 1))) {
      AnimationFrames frames = AnimationFixture.frames(folder, "25", opaque, other);
      assertThatThrownBy(() -> written(frames))
          .isInstanceOf(ImageFormatException.class)
          .hasMessageContaining("frame-001.png: expected the bits and channels of")
          .hasMessageEndingWith("frame-000.png");
    }
    AnimationFrames frames = AnimationFixture.frames(folder, "25", opaque);
    PngFixture png = new PngFixture().header(2, 2, 8, PngFixture.PALETTE, false);
    png.chunk("PLTE", new byte[3]).data(2, 2, 8, PngFixture.PALETTE, false, (i, y) -> 0);
    Files.write(frames.files().get(0), png.end());
    assertThatThrownBy(() -> written(frames)).hasMessageContaining("palette");
  }

  @Test
  void anInterruptEndsTheWork() throws IOException {
    Pixels picture = random(2, 2, 3, 8, 1);
    AnimationFrames frames = AnimationFixture.frames(folder, "25", picture, picture);
    assertCancelled(() -> written(frames));
  }
}
