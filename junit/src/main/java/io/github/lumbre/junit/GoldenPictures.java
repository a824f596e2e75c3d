package io.github.lumbre.junit;

import io.github.lumbre.image.Image;
import java.util.Objects;

/**
 * Compares pictures with golden ones: pictures that were looked at once, and are kept with the
 * tests.
 *
 * <pre>{@code
 * import static io.github.lumbre.junit.GoldenPictures.assertThatPicture;
 *
 * assertThatPicture(image).matches("cornell");
 * }</pre>
 *
 * <p>System properties:
 *
 * <ul>
 *   <li>{@code lumbre.golden=store} stores the pictures of the tests that run, instead of comparing
 *       them
 *   <li>{@code lumbre.golden.folder}: the folder of golden pictures; the default is {@code
 *       src/test/golden}
 *   <li>{@code lumbre.golden.report}: where the pictures of failures are written; the default is
 *       {@code target/golden}
 * </ul>
 */
public final class GoldenPictures {
  /**
   * The tolerance if a test states none: the mean of LDR-FLIP over all pixels. It is about that of
   * one step of 8 bits.
   */
  public static final double DEFAULT_TOLERANCE = .01;

  /** The mean of LDR-FLIP in any tile may be this many times as large as the tolerance. */
  public static final double TILE_FACTOR = 10;

  /** The side of the tiles, in pixels. */
  public static final int TILE = 8;

  private GoldenPictures() {}

  /** Returns assertions about a picture. */
  public static PictureAssert assertThatPicture(Image picture) {
    Objects.requireNonNull(picture, "picture");
    return new PictureAssert(picture, GoldenSettings.ofSystem());
  }
}
