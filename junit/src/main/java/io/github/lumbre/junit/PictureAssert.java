package io.github.lumbre.junit;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.opentest4j.AssertionFailedError;

/** Assertions about a picture. Immutable: methods that configure it return a new one. */
public final class PictureAssert {
  private final Image picture;
  private final GoldenSettings settings;
  private final double tolerance;
  private final ImageWriter.Options options;

  PictureAssert(Image picture, GoldenSettings settings) {
    this(picture, settings, GoldenPictures.DEFAULT_TOLERANCE, ImageWriter.Options.DEFAULT);
  }

  private PictureAssert(
      Image picture, GoldenSettings settings, double tolerance, ImageWriter.Options options) {
    this.picture = picture;
    this.settings = settings;
    this.tolerance = tolerance;
    this.options = options;
  }

  /**
   * Returns assertions with another tolerance.
   *
   * @param meanFlip the largest mean of LDR-FLIP over all pixels, in [0,1]; in any tile of 8x8
   *     pixels, the mean may be {@link GoldenPictures#TILE_FACTOR} times as large. With 0, the
   *     pixels must be equal
   */
  public PictureAssert withTolerance(double meanFlip) {
    if (!(meanFlip >= 0 && meanFlip <= 1)) {
      throw new IllegalArgumentException(
          "meanFlip: expected a number from 0 to 1, found " + meanFlip);
    }
    return new PictureAssert(picture, settings, meanFlip, options);
  }

  /**
   * Returns assertions about the picture as a PNG shows it with an exposure, a tone curve and 8 or
   * 16 bits. The default is the sRGB curve and 8 bits. EXR files hold linear light without them.
   */
  public PictureAssert developedWith(ImageWriter.Options newOptions) {
    Objects.requireNonNull(newOptions, "newOptions");
    return new PictureAssert(picture, settings, tolerance, newOptions);
  }

  /**
   * Requires that the picture equals a golden one, or looks the same within the tolerance.
   *
   * @param name of the golden picture in its folder, such as {@code cornell} or {@code
   *     lights/spot.exr}; ends in .png or .exr, or is completed with .png. Names have letters,
   *     digits, '.', '_' and '-' between slashes
   * @throws AssertionError if it differs, or if there is no golden picture; the message has the
   *     command that accepts the picture
   */
  public void matches(String name) {
    GoldenFile golden = GoldenFile.of(settings.folder(), name);
    Accepting accepting = Accepting.ofCaller();
    try {
      GoldenFile.Encoded actual = golden.encode(picture, options);
      if (settings.stores()) {
        golden.store(actual);
      } else if (!golden.exists()) {
        throw failure(
            "golden picture: expected " + golden.path() + ", found none", "make", accepting);
      } else {
        compare(golden, actual, accepting);
        FailurePage.delete(settings.report(), golden);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("golden picture " + golden.path() + ": " + e, e);
    }
  }

  private void compare(GoldenFile golden, GoldenFile.Encoded actual, Accepting accepting)
      throws IOException {
    GoldenFile.Encoded expected;
    try {
      expected = golden.read();
    } catch (ImageFormatException e) {
      String found = "golden picture " + golden.path() + ": expected a picture, found ";
      throw failure(found + golden.whatElse(e), "replace", accepting);
    }
    if (actual.hash().equals(expected.hash())) {
      return;
    }
    Optional<Difference> difference =
        Difference.haveSameSize(actual, expected)
            ? Optional.of(Difference.of(actual, expected))
            : Optional.empty();
    if (difference.isPresent() && difference.get().isWithin(tolerance)) {
      return;
    }
    Image found = actual.image();
    Image wanted = expected.image();
    String text =
        difference
            .map(each -> each.text(tolerance, found))
            .orElse(
                String.format(
                    Locale.ROOT,
                    "expected %dx%d pixels, found %dx%d",
                    wanted.width(),
                    wanted.height(),
                    found.width(),
                    found.height()));
    String look = page(golden, actual, expected, difference, text);
    throw failure(
        "picture differs from " + golden.path() + ": " + text + "\n  " + look, "accept", accepting);
  }

  /** Writes the page of a failure, and returns a line that says where it is. */
  private String page(
      GoldenFile golden,
      GoldenFile.Encoded actual,
      GoldenFile.Encoded expected,
      Optional<Difference> difference,
      String text) {
    try {
      Path page = FailurePage.write(settings.report(), golden, actual, expected, difference, text);
      return "look at it: " + page.toUri();
    } catch (IOException e) {
      return "its page cannot be written: " + e;
    }
  }

  private AssertionFailedError failure(String text, String verb, Accepting accepting) {
    String folder = Files.exists(settings.folder()) ? "" : " (creates the folder)";
    return new AssertionFailedError(text + "\n  " + verb + " it: " + accepting.command() + folder);
  }
}
