package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import java.util.Optional;

/**
 * The black lines on pictures of a scene, and of the same scene from other places, as its settings
 * ask for. Immutable.
 *
 * @param outlines the edges of the scene; empty if no lines are drawn
 */
public record LineDrawing(RenderSettings settings, Optional<Outlines> outlines) {
  /**
   * Returns the drawing of a scene; it finds the edges if there are lines to draw.
   *
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static LineDrawing of(Scene scene, RenderSettings settings) {
    boolean isOn = settings.get(Setting.LINE_WIDTH) > 0;
    return new LineDrawing(settings, isOn ? Optional.of(Outlines.of(scene)) : Optional.empty());
  }

  /**
   * Returns the lines of a picture; empty if there are none to draw.
   *
   * @param scene the scene of this drawing, from any place
   */
  public Optional<Strokes> strokes(Scene scene) {
    return outlines.flatMap(edges -> edges.strokes(scene, settings));
  }

  public Pen pen() {
    return new Pen(Rgb.BLACK, settings.get(Setting.LINE_WIDTH));
  }
}
