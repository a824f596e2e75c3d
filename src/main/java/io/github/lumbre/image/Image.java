package io.github.lumbre.image;

import io.github.lumbre.image.internal.DisplayPicture;
import io.github.lumbre.image.internal.DisplayRows;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.LinearPicture;
import java.awt.image.BufferedImage;
import java.util.Objects;

/**
 * A picture in linear RGB: width × height pixels, row 0 at the top, optionally with straight (not
 * premultiplied) alpha.
 *
 * <p>The arrays are not copied: a caller that keeps a reference to them shares them with the
 * picture.
 */
public final class Image {
  private static final float[] OPAQUE = {};

  private final int width;
  private final int height;
  private final float[] rgb;
  private final float[] alpha;

  /**
   * Creates a picture from its rasters, which are not copied.
   *
   * @param width in pixels, at least 1
   * @param height in pixels, at least 1
   * @param rgb three values per pixel, row by row
   * @param alpha one value in [0,1] per pixel, or an empty array for an opaque picture
   * @throws IllegalArgumentException if the sizes are inconsistent
   */
  public Image(int width, int height, float[] rgb, float[] alpha) {
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException(
          "width and height: expected at least 1, found " + width + "x" + height);
    }
    long pixels = (long) width * height;
    if (Objects.requireNonNull(rgb, "rgb").length != 3 * pixels) {
      throw new IllegalArgumentException(
          "rgb: expected " + 3 * pixels + " values, found " + rgb.length);
    }
    if (Objects.requireNonNull(alpha, "alpha").length != 0 && alpha.length != pixels) {
      throw new IllegalArgumentException(
          "alpha: expected 0 or " + pixels + " values, found " + alpha.length);
    }
    this.width = width;
    this.height = height;
    this.rgb = rgb;
    this.alpha = alpha;
  }

  /** Returns an opaque black picture. */
  public static Image black(int width, int height) {
    return new Image(width, height, new float[Math.multiplyExact(3, width * height)], OPAQUE);
  }

  /** Returns the number of columns. */
  public int width() {
    return width;
  }

  /** Returns the number of rows. */
  public int height() {
    return height;
  }

  /** Returns whether the pixels have an alpha of their own; otherwise all are opaque. */
  public boolean hasAlpha() {
    return alpha.length != 0;
  }

  /** Returns the pixel in column x from the left, row y from the top. */
  public Rgb pixel(int x, int y) {
    int i = 3 * index(x, y);
    return new Rgb(rgb[i], rgb[i + 1], rgb[i + 2]);
  }

  /** Returns the alpha of a pixel; 1 everywhere in an opaque picture. */
  public float alpha(int x, int y) {
    return alpha.length == 0 ? 1 : alpha[index(x, y)];
  }

  /**
   * Returns a component of a pixel as OpenEXR files store it: multiplied by alpha where that is not
   * 0, so that {@link LinearPicture#straight} returns the color.
   */
  public float associated(int x, int y, int component) {
    float value = rgb[3 * index(x, y) + component];
    float share = alpha(x, y);
    return share == 0 ? value : value * share;
  }

  /** Returns the raster itself, not a copy: three values per pixel, row by row. */
  public float[] rgb() {
    return rgb;
  }

  /** Returns the bytes of a PFM file, which has all bits of the colors; alpha is left out. */
  public byte[] toPfm() {
    return ImageFormat.PFM.bytes(this, ImageWriter.Options.DEFAULT);
  }

  /** Returns the bytes of a PNG file with {@link ImageWriter.Options#DEFAULT}. */
  public byte[] toPng() {
    return toPng(ImageWriter.Options.DEFAULT);
  }

  /** Returns the bytes of a PNG file: those that {@link ImageWriter} writes with these options. */
  public byte[] toPng(ImageWriter.Options options) {
    return ImageFormat.PNG.bytes(this, options);
  }

  /**
   * Returns the bytes of a JPEG file: those that {@link ImageWriter} writes with these options.
   *
   * @throws IllegalArgumentException if a side is longer than {@link ImageWriter#MAX_JPEG_SIDE}
   */
  public byte[] toJpeg(ImageWriter.Options options) {
    return ImageFormat.JPG.bytes(this, options);
  }

  /**
   * Returns the bytes of an OpenEXR file, which has all bits of the colors and alpha: those that
   * {@link ImageWriter} writes with these options.
   */
  public byte[] toExr(ImageWriter.Options options) {
    return ImageFormat.EXR.bytes(this, options);
  }

  /**
   * Returns the picture for display in Java's own type, with the pixels of {@link
   * #toPng(ImageWriter.Options)} in 8 bits: {@code TYPE_4BYTE_ABGR} if there is alpha, otherwise
   * {@code TYPE_3BYTE_BGR}.
   *
   * @param options whose exposure and tone curve are used; the others are ignored
   */
  public BufferedImage toBufferedImage(ImageWriter.Options options) {
    return DisplayPicture.of(DisplayRows.of(this, options, Byte.SIZE, hasAlpha()));
  }

  private int index(int x, int y) {
    Objects.checkIndex(x, width);
    return Objects.checkIndex(y, height) * width + x;
  }

  /** Returns the size and whether there is alpha, for people. */
  @Override
  public String toString() {
    return "Image of " + width + "x" + height + " pixels" + (hasAlpha() ? " with alpha" : "");
  }
}
