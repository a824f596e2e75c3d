package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Rgb;
import java.util.Objects;

/**
 * How strokes are drawn. Ends and joins are round.
 *
 * @param color in the light of the picture that is drawn on
 * @param width in pixels, more than 0 and at most {@link #MAX_WIDTH}
 * @param opacity in [0,1]
 */
public record Pen(Rgb color, double width, double opacity) {
  /** The largest width in pixels. */
  public static final double MAX_WIDTH = 1000;

  /**
   * @throws IllegalArgumentException if a number is not in its range
   */
  public Pen {
    Objects.requireNonNull(color, "color");
    if (!(width > 0 && width <= MAX_WIDTH)) {
      throw new IllegalArgumentException(
          "width: expected more than 0 and at most " + MAX_WIDTH + ", found " + width);
    }
    if (!(opacity >= 0 && opacity <= 1)) {
      throw new IllegalArgumentException("opacity: expected 0 to 1, found " + opacity);
    }
  }

  /** Creates an opaque pen. */
  public Pen(Rgb color, double width) {
    this(color, width, 1);
  }
}
