package io.github.lumbre.stage.drawing;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.Optional;

/**
 * Where a camera looks from, through the center of its lens.
 *
 * @param position of the eye in perspective
 * @param forward unit direction of the view
 * @param pixels the map from world space to pixels
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 */
record Eye(Vec3 position, Vec3 forward, Projection pixels, int width, int height) {
  /** Returns the eye of a camera; empty if the camera bends straight lines. */
  static Optional<Eye> of(Camera camera, RenderSettings settings) {
    Crop window = settings.window();
    return Projection.of(camera, settings.width(), settings.height())
        .map(whole -> whole.cropped(window.x(), window.y()))
        .map(
            pixels ->
                new Eye(
                    camera.position(),
                    camera.axes().normal(),
                    pixels,
                    window.width(),
                    window.height()));
  }

  /** Returns the vector from where the ray to a point starts to the point. */
  Vec3 rayTo(Vec3 point) {
    return pixels.isParallel() ? forward.times(pixels.pixel(point).z()) : point.minus(position);
  }

  double depth(Vec3 point) {
    return pixels.pixel(point).z();
  }

  Point2 pixel(Vec3 point) {
    Vec3 pixel = pixels.pixel(point);
    return new Point2(pixel.x(), pixel.y());
  }
}
