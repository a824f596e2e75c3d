package io.github.lumbre.stage.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelOptions;
import java.util.List;
import java.util.Optional;

/**
 * How a model is shown: as its file says, or its shape alone.
 *
 * @param isClay whether its surfaces are matte and light gray
 * @param hasLines whether lines are drawn on silhouettes, creases and borders
 */
public record Look(boolean isClay, boolean hasLines) {
  /** As the file says. */
  public static final Look OF_FILE = new Look(false, false);

  /** The name of lines. */
  public static final String LINES = "lines";

  /** The default width of lines, in pixels. */
  public static final double LINE_WIDTH = 1.5;

  /**
   * Returns a look of the shape alone.
   *
   * @param text clay, lines, or both, separated by a comma
   * @throws IllegalArgumentException that says what was expected, for any other text
   */
  public static Look of(String text) {
    List<String> names = List.of(text.split(",", -1));
    if (!List.of(ModelOptions.CLAY, LINES).containsAll(names)) {
      throw new IllegalArgumentException("expected clay, lines or clay,lines, found " + text);
    }
    return new Look(names.contains(ModelOptions.CLAY), names.contains(LINES));
  }

  /** Returns the look in a text; as the file says without one. */
  public static Look of(Optional<String> text) {
    return text.map(Look::of).orElse(OF_FILE);
  }

  /** Returns whether it is a drawing: lines on white paper, without shadows. */
  public boolean isDrawing() {
    return hasLines && !isClay;
  }

  /** Returns what replaces all materials; empty for those of the file. */
  public Optional<String> materials() {
    Optional<String> clay = isClay ? Optional.of(ModelOptions.CLAY) : Optional.empty();
    return isDrawing() ? Optional.of(ModelOptions.WHITE) : clay;
  }

  /** Returns the name of the sky, if nothing else is asked for. */
  public String sky() {
    return isDrawing() ? "white" : "studio";
  }

  /** Returns the color behind the model, if nothing else is asked for; empty for the sky. */
  public Optional<Rgb> background() {
    return isClay || hasLines ? Optional.of(Rgb.WHITE) : Optional.empty();
  }

  /** Returns the width of lines in pixels, if nothing else is asked for; 0 for no lines. */
  public double lineWidth() {
    return hasLines ? LINE_WIDTH : 0;
  }
}
