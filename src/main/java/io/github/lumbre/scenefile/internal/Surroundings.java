package io.github.lumbre.scenefile.internal;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/**
 * What is around a model that is rendered by itself, and how it was read.
 *
 * @param camera of the scene, in the middle of its motion
 * @param moving name of the model's camera that moves with the pose; empty if it stands still
 * @param backplate what the camera sees instead of the sky; empty if it sees the sky, or the color
 *     of the settings
 * @param hasGround whether the model stands on an infinite floor
 * @param box around what the camera has in its frame, on whose lowest point the floor is
 * @param assembled the box around the model before its parts moved apart; empty if they did not
 * @param options of the model
 * @param settings of the scene
 * @param labels what to draw on its pictures
 * @param title the name of the view
 * @param sheet how lines are drawn
 */
public record Surroundings(
    PlacedCamera camera,
    Optional<String> moving,
    Sky sky,
    Optional<Backplate> backplate,
    boolean hasGround,
    Bounds3 box,
    Optional<Bounds3> assembled,
    ModelOptions options,
    RenderSettings settings,
    Set<String> labels,
    String title,
    DrawingSheet sheet) {
  /**
   * The light of the surroundings.
   *
   * @param name {@code studio}, {@code white}, {@code sun}, or that of the picture
   * @param picture absolute path of its picture; empty if it has none
   * @param azimuth of the sun in degrees
   * @param elevation of the sun in degrees
   */
  public record Sky(
      String name,
      Optional<Path> picture,
      double intensity,
      double rotation,
      double azimuth,
      double elevation) {
    /** Returns whether it is a clear day's, with the sun. */
    public boolean hasSun() {
      return name.equals("sun");
    }
  }
}
