package io.github.lumbre.fuzz;

import io.github.lumbre.fuzz.HostileScenes.Ending;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.image.internal.LinearReader;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;

/**
 * Malformed picture files that try to break readers: OpenEXR, portable float maps, PNG, JPEG, TGA,
 * DDS, BMP, GIF and TIFF. Each is a function of a seed. Thread-safe.
 */
final class HostilePictures {
  private static final int MOST_PIXELS = 512;
  private static final int LONGEST_LINE = 300;

  private final LinearPictureMutator linear;

  /**
   * @param folder receives valid files
   */
  HostilePictures(Path folder) {
    linear = LinearPictureMutator.in(folder);
  }

  /** Returns the file of a seed. */
  byte[] file(long seed) {
    Random random = new Random(seed);
    return random.nextInt(4) == 0
        ? new PictureMutator(random).next()
        : linear.drawingFrom(random).next();
  }

  /**
   * Reads the picture of a seed and compares it with a gray one.
   *
   * @return the ending, with the exit code of {@code lumbre compare}
   * @throws AssertionError if the ending is not allowed
   */
  Ending run(long seed) {
    byte[] file = file(seed);
    try {
      return new Ending(exitCode(file), 0);
    } catch (RuntimeException | Error e) {
      throw new AssertionError("seed " + seed + ": " + HexFormat.of().formatHex(file), e);
    }
  }

  private static int exitCode(byte[] file) {
    Image image;
    try {
      image = LinearReader.decode(file);
    } catch (ImageFormatException e) {
      requireTellable(e.getMessage());
      return e.kind() == ImageFormatException.Kind.TOO_LARGE ? 5 : 4;
    }
    for (float value : image.rgb()) {
      if (!Float.isFinite(value)) {
        return 4;
      }
    }
    if (image.rgb().length <= 3 * MOST_PIXELS) {
      requireFinite(PictureError.of(image, gray(image.width(), image.height())));
      requireFinite(PictureError.of(gray(image.width(), image.height()), image));
    }
    return 0;
  }

  private static Image gray(int width, int height) {
    Image gray = Image.black(width, height);
    Arrays.fill(gray.rgb(), .5f);
    return gray;
  }

  private static void requireFinite(PictureError error) {
    error.byName().forEach((name, value) -> require(Double.isFinite(value), name + " is " + value));
  }

  private static void requireTellable(String line) {
    require(line.length() <= LONGEST_LINE, "too long: " + line);
    require(!line.contains("Exception") && !line.contains("java."), "not for people: " + line);
    require(line.codePoints().noneMatch(Character::isISOControl), "controls terminals: " + line);
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new AssertionError(otherwise);
    }
  }
}
