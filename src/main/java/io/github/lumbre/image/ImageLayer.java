package io.github.lumbre.image;

import java.util.List;
import java.util.Objects;

/**
 * A named set of channels of a picture, such as normals: width × height pixels, row 0 at the top.
 *
 * <p>The array is not copied: a caller that keeps a reference to it shares it with the layer.
 *
 * @param name in OpenEXR files, its channels have this name, a dot and the channel's name; it may
 *     contain dots; empty for channels without a prefix
 * @param channels the names of the channels, such as X, Y and Z, in the order of their values
 * @param precision how OpenEXR files store the values
 * @param width in pixels, at least 1
 * @param height in pixels, at least 1
 * @param values one value for each channel, pixel by pixel
 */
public record ImageLayer(
    String name,
    List<String> channels,
    Precision precision,
    int width,
    int height,
    float[] values) {

  /** The number format of a layer's channels in OpenEXR files. */
  public enum Precision {
    /** 16 bits: 11 significant bits, up to 65504. */
    HALF,
    /** 32 bits. */
    FLOAT
  }

  /**
   * @throws IllegalArgumentException if a name or a size is invalid
   */
  public ImageLayer {
    channels = List.copyOf(channels);
    Objects.requireNonNull(precision, "precision");
    requireName("name", name, 0);
    channels.forEach(channel -> requireName("channels", channel, 1));
    if (channels.isEmpty() || channels.stream().distinct().count() != channels.size()) {
      throw new IllegalArgumentException("channels: expected different names, found " + channels);
    }
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException(
          "width and height: expected at least 1, found " + width + "x" + height);
    }
    long expected = (long) width * height * channels.size();
    if (values.length != expected) {
      throw new IllegalArgumentException(
          "values: expected " + expected + ", found " + values.length);
    }
  }

  private static void requireName(String what, String name, int least) {
    boolean isPrintable = name.chars().noneMatch(Character::isISOControl);
    if (name.length() < least || name.length() > 255 || !isPrintable) {
      throw new IllegalArgumentException(
          "%s: expected %s to 255 characters without control characters, found '%s'"
              .formatted(what, least, name));
    }
  }

  /** Returns a picture as the layer without a name that OpenEXR files have: R, G, B, perhaps A. */
  public static ImageLayer of(Image image) {
    int count = image.hasAlpha() ? 4 : 3;
    int width = image.width();
    float[] values = new float[Math.multiplyExact(count, width * image.height())];
    for (int i = 0; i < values.length; i++) {
      int x = i / count % width;
      int y = i / count / width;
      values[i] = i % count < 3 ? image.associated(x, y, i % count) : image.alpha(x, y);
    }
    List<String> channels = List.of("R", "G", "B", "A").subList(0, count);
    return new ImageLayer("", channels, Precision.FLOAT, width, image.height(), values);
  }

  /** Returns a value. */
  public float value(int x, int y, int channel) {
    Objects.checkIndex(x, width);
    Objects.checkIndex(y, height);
    Objects.checkIndex(channel, channels.size());
    return values[(y * width + x) * channels.size() + channel];
  }

  /**
   * Returns the first three channels as a picture: a single one as gray, and black for a missing
   * third.
   */
  public Image toImage() {
    int count = channels.size();
    float[] rgb = new float[Math.multiplyExact(3, width * height)];
    for (int i = 0; i < width * height; i++) {
      for (int c = 0; c < 3; c++) {
        int from = count == 1 ? 0 : c;
        rgb[3 * i + c] = from < count ? values[i * count + from] : 0;
      }
    }
    return new Image(width, height, rgb, new float[0]);
  }
}
