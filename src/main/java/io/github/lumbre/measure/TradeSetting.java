package io.github.lumbre.measure;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;

/**
 * A way to render a scene that a study measures at several numbers of samples.
 *
 * @param knob what is turned: {@code depth}, {@code mode}
 * @param value of the knob, as on the command line
 * @param isUnbiased whether the mean of all such pictures is taken for the truth, so that samples
 *     alone stand between picture and reference
 * @param scene as read for the settings' mode
 */
public record TradeSetting(
    String knob, String value, boolean isUnbiased, Scene scene, RenderSettings settings) {
  /** Returns knob and value as flags say them. */
  public String label() {
    return knob + " " + value;
  }
}
