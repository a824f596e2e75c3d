package io.github.lumbre.testing;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Pixels;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/** Small picture files, written by the JDK, and the pixels of others. */
public final class Pictures {
  private Pictures() {}

  /** Returns an opaque picture whose pixels, by rows, have these colors, repeatedly. */
  public static BufferedImage of(int width, int height, int... colors) {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < width * height; i++) {
      image.setRGB(i % width, i / width, colors[i % colors.length]);
    }
    return image;
  }

  /** Returns the PNG file of {@link #of}. */
  public static byte[] png(int width, int height, int... colors) {
    return file(of(width, height, colors), "png");
  }

  /** Returns a picture as a file of a format that the JDK writes. */
  public static byte[] file(BufferedImage image, String format) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      if (!ImageIO.write(image, format, out)) {
        throw new AssertionError(format);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }

  /** Returns the colors of all pixels, by rows, with alpha. */
  public static int[] pixels(BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  /** Returns the colors of all pixels of a file, by rows, with alpha. */
  public static int[] pixels(Path file) throws IOException {
    return pixels(ImageIO.read(file.toFile()));
  }

  /** Checks that two pictures have the same values, those of alpha included. */
  public static void assertSame(Pixels found, Pixels expected) {
    assertThat(found).hasToString(expected.toString());
    for (int y = 0; y < expected.height(); y++) {
      for (int x = 0; x < expected.width(); x++) {
        assertThat(found.alpha(x, y)).isEqualTo(expected.alpha(x, y));
        for (int channel = 0; channel < 3; channel++) {
          assertThat(found.raw(x, y, channel)).isEqualTo(expected.raw(x, y, channel));
        }
      }
    }
  }
}
