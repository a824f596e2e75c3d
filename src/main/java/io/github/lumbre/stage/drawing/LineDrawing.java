package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.internal.PartSurface;
import java.util.Map;
import java.util.Optional;

/**
 * The black lines on pictures of a scene, and of the same scene from other places, as its settings
 * ask for. Immutable.
 *
 * @param outlines the edges of the scene; empty if no lines are drawn
 * @param hasHidden whether hidden lines are dashed; otherwise they are left out
 */
public record LineDrawing(
    RenderSettings settings, Optional<Outlines> outlines, boolean hasHidden) {
  /** The widths of hidden lines, of their dashes and of the gaps, in widths of visible lines. */
  static final double HIDDEN_WIDTH = .75;

  static final double DASH = 4;
  static final double GAP = 3;

  /**
   * Returns the drawing of a scene; it finds the edges if there are lines to draw.
   *
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static LineDrawing of(Scene scene, RenderSettings settings, boolean hasHidden) {
    boolean isOn = settings.get(Setting.LINE_WIDTH) > 0;
    return new LineDrawing(
        settings, isOn ? Optional.of(Outlines.of(scene)) : Optional.empty(), hasHidden);
  }

  /** Returns whether lines are drawn for the camera of a scene: none if it bends straight lines. */
  public boolean areOn(Scene scene) {
    return outlines.isPresent() && Eye.of(scene.camera(), settings).isPresent();
  }

  /**
   * Draws the lines of a picture.
   *
   * @param scene the scene of this drawing, from any place
   * @param numbers of the parts, whose hidden lines are not joined
   */
  public void draw(Scene scene, PartOf numbers, Canvas canvas) {
    Optional<Sketch> found =
        outlines.flatMap(edges -> edges.sketch(scene, settings, numbers, hasHidden));
    if (found.isEmpty()) {
      return;
    }
    double width = settings.get(Setting.LINE_WIDTH);
    if (hasHidden) {
      found
          .get()
          .settled()
          .hidden()
          .values()
          .forEach(
              strokes ->
                  canvas.draw(
                      Polylines.dashed(Chains.of(strokes), DASH * width, GAP * width),
                      new Pen(Rgb.BLACK, HIDDEN_WIDTH * width)));
    }
    found.get().visible().values().forEach(lines -> canvas.draw(lines, new Pen(Rgb.BLACK, width)));
  }

  /**
   * Draws the colored surfaces and hatches of a picture that shows nothing but lines besides.
   *
   * @param scene the scene of this drawing, from any place
   * @param surfaces of the model, by the numbers of their primitives
   */
  public void drawSurfaces(
      Scene scene, Map<Integer, PartSurface> surfaces, PartOf numbers, Canvas canvas) {
    Surfaces colored = Surfaces.of(scene, settings, surfaces, numbers);
    colored.fills().forEach(fill -> canvas.fill(fill.outlines(), fill.color()));
    colored.hatches().forEach(hatch -> canvas.draw(hatch.strokes(), hatch.pen()));
  }
}
