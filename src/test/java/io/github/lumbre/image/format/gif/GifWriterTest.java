package io.github.lumbre.image.format.gif;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.animation.AnimationFixture;
import io.github.lumbre.image.animation.AnimationFrames;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests animated GIF files with a decoder of their own and with Java's. */
class GifWriterTest {
  @TempDir private Path folder;

  private byte[] gif(String rate, Pixels... pictures) throws IOException {
    return written(AnimationFixture.frames(folder, rate, pictures));
  }

  private static byte[] written(AnimationFrames frames) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    GifWriter.write(frames, out);
    return out.toByteArray();
  }

  private static Pixels opaque(int width, int height, IntBinaryOperator rgb) {
    return AnimationFixture.pixels(width, height, false, rgb);
  }

  /** Returns the pixels of Java's reader, which decodes rectangles only. */
  private static BufferedImage byJava(byte[] file, int frame) throws IOException {
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(file))) {
      reader.setInput(in);
      return reader.read(frame);
    } finally {
      reader.dispose();
    }
  }

  private static int[] expected(Pixels pixels) {
    int[] expected = new int[pixels.width() * pixels.height()];
    for (int i = 0; i < expected.length; i++) {
      int x = i % pixels.width();
      int y = i / pixels.width();
      int rgb = pixels.raw(x, y, 0) << 16 | pixels.raw(x, y, 1) << 8 | pixels.raw(x, y, 2);
      expected[i] = pixels.alpha(x, y) < 128 ? 0 : 0xff << 24 | rgb;
    }
    return expected;
  }

  /** Widths of codes grow from 3 bits, and 300 x 300 random pixels fill the table many times. */
  @ParameterizedTest
  @CsvSource({
    "1, 1, 1",
    "1, 1, 2",
    "7, 1, 3",
    "1, 5, 4",
    "2, 2, 5",
    "33, 17, 16",
    "64, 64, 17",
    "300, 300, 2",
    "300, 300, 129",
    "300, 300, 256",
    "255, 3, 255",
    "1000, 1, 7"
  })
  void fewColorsAreExact(int width, int height, int colors) throws IOException {
    Random random = new Random(colors);
    int[] palette = random.ints(colors, 0, 1 << 24).toArray();
    Pixels[] pictures = new Pixels[3];
    for (int i = 0; i < pictures.length; i++) {
      pictures[i] = opaque(width, height, (x, y) -> palette[random.nextInt(colors)]);
    }
    byte[] file = gif("25", pictures);
    GifFixture gif = new GifFixture(file);
    assertThat(gif.frames).hasSize(pictures.length);
    for (int i = 0; i < pictures.length; i++) {
      assertThat(gif.frames.get(i).screen()).isEqualTo(expected(pictures[i]));
    }
    int[] first = byJava(file, 0).getRGB(0, 0, width, height, null, 0, width);
    assertThat(first).isEqualTo(expected(pictures[0]));
  }

  @Test
  void timesAreInTheFile() throws IOException {
    Pixels white = opaque(2, 2, (x, y) -> 0xffffff);
    Pixels black = opaque(2, 2, (x, y) -> 0);
    GifFixture gif = new GifFixture(gif("30", white, black, white, black));
    assertThat(gif.frames.stream().map(GifFixture.Frame::hundredths)).containsExactly(3, 4, 3, 3);
  }

  @Test
  void onlyTheRectangleThatChangesIsStored() throws IOException {
    IntBinaryOperator still = (x, y) -> 0x010000 * x + y / 2;
    Pixels first = opaque(16, 16, still);
    Pixels second =
        opaque(
            16, 16, (x, y) -> x == 3 && y == 5 || x == 6 && y == 4 ? 0xff : still.applyAsInt(x, y));
    GifFixture gif = new GifFixture(gif("10", first, second, second, first));
    assertThat(gif.frames.stream().map(GifFixture.Frame::pixels)).containsExactly(256, 8, 1, 8);
    assertThat(gif.frames.get(1).screen()).isEqualTo(expected(second));
    assertThat(gif.frames.get(2).screen()).isEqualTo(expected(second));
    assertThat(gif.frames.get(3).screen()).isEqualTo(expected(first));
  }

  /** A moving disk, with 256 colors and transparency: nothing of it stays behind. */
  @Test
  void transparentFramesAreNotDrawnOverEachOther() throws IOException {
    Pixels[] pictures = new Pixels[4];
    for (int i = 0; i < 3; i++) {
      int center = 10 + 10 * i;
      pictures[i] =
          AnimationFixture.pixels(
              40,
              20,
              true,
              (x, y) -> {
                boolean isInside = Math.hypot(x - center, y - 10) < 7;
                return (isInside ? 0x80 + x : 0x7f) << 24 | x << 16 | y << 3;
              });
    }
    pictures[3] = AnimationFixture.pixels(40, 20, true, (x, y) -> 0xffffff);
    GifFixture gif = new GifFixture(gif("25", pictures));
    int[] last = gif.frames.get(3).screen();
    assertThat(last).containsOnly(0);
    for (int frame = 0; frame < 3; frame++) {
      int[] expected = expected(pictures[frame]);
      int[] screen = gif.frames.get(frame).screen();
      for (int i = 0; i < screen.length; i++) {
        assertThat(screen[i] >>> 24).isEqualTo(expected[i] >>> 24);
      }
    }
  }

  @Test
  void sixteenBitsAreRounded() throws IOException {
    short[] values = {0x0101, 0x0080, (short) 0xffff, 0x7fff, (short) 0xff7e, 0x4040};
    GifFixture gif = new GifFixture(gif("1", Pixels.of(2, 1, 3, values)));
    assertThat(gif.frames.get(0).screen()).containsExactly(0xff0100ff, 0xff7ffe40);
  }

  @Test
  void damagedAndDifferentFramesAreNamed() throws IOException {
    Pixels small = opaque(2, 2, (x, y) -> 0);
    AnimationFrames frames =
        AnimationFixture.frames(folder, "25", small, opaque(2, 3, (x, y) -> 0), small);
    assertThatThrownBy(() -> written(frames))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageContaining("frame-001.png: has 2x3 pixels, expected 2x2, as")
        .hasMessageEndingWith("frame-000.png has");
    byte[] damaged = small.toPng();
    damaged[damaged.length - 20]++;
    Files.write(frames.files().get(1), damaged);
    assertThatThrownBy(() -> written(frames)).hasMessageContaining("frame-001.png: PNG is damaged");
    Files.writeString(frames.files().get(1), "GIF89a");
    assertThatThrownBy(() -> written(frames)).hasMessageContaining("frame-001.png: expected a PNG");
    Files.delete(frames.files().get(1));
    assertThatThrownBy(() -> written(frames)).isInstanceOf(IOException.class);
    assertThatThrownBy(() -> AnimationFrames.open(List.of(), frames.rate()))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void anInterruptEndsTheWork() throws IOException {
    AnimationFrames frames = AnimationFixture.frames(folder, "25", opaque(2, 2, (x, y) -> 0));
    assertCancelled(() -> written(frames));
  }
}
