package io.github.lumbre.scene.internal;

import io.github.lumbre.scene.RenderSettings;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The size of a frame in pixels, as a user states it. Immutable.
 *
 * @param width at most nine digits; without a height, it is the longer side
 * @param height at most nine digits; empty to keep the aspect ratio
 */
public record FrameSize(int width, OptionalInt height) {
  private static final Pattern FORM = Pattern.compile("(\\d{1,9})(?:x(\\d{1,9}))?");

  /**
   * Returns the size in a text such as {@code 640x480} or {@code 640}.
   *
   * @throws IllegalArgumentException if the text has another form
   */
  public static FrameSize of(String text) {
    Matcher found = FORM.matcher(text);
    if (!found.matches()) {
      throw new IllegalArgumentException(
          "expected WxH, such as 640x480, or the longer side, such as 640, found '" + text + "'");
    }
    return new FrameSize(
        Integer.parseInt(found.group(1)),
        found.group(2) == null
            ? OptionalInt.empty()
            : OptionalInt.of(Integer.parseInt(found.group(2))));
  }

  /**
   * Returns settings with this size.
   *
   * @param settings whose aspect ratio stays, to a pixel, if this size has no height
   * @throws IllegalArgumentException if a side is out of range
   */
  public RenderSettings over(RenderSettings settings) {
    double longer = Math.max(settings.width(), settings.height());
    return settings.toBuilder()
        .size(
            height.isPresent() ? width : scaled(settings.width() / longer),
            height.orElseGet(() -> scaled(settings.height() / longer)))
        .build();
  }

  /** Returns the text that {@link #of} reads. Picocli asks for it. */
  @Override
  public String toString() {
    return height.isPresent() ? width + "x" + height.getAsInt() : Integer.toString(width);
  }

  private int scaled(double ofLonger) {
    return (int) Math.max(Math.min(1, width), Math.round(width * ofLonger));
  }
}
