package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Optional;

/**
 * A full panorama of 360° by 180° in longitude and latitude. The center of the film looks along +z.
 */
final class SphericalCamera extends Camera {
  /**
   * Creates a camera.
   *
   * @param position the eye, in world space
   * @param axes the orthonormal world-space directions right, up and forward
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   * @throws IllegalArgumentException if the aspect is out of range
   */
  public SphericalCamera(Vec3 position, Frame axes, double aspect) {
    super(position, axes, aspect);
  }

  @Override
  public SphericalCamera movedTo(Vec3 newPosition, Frame newAxes) {
    return new SphericalCamera(newPosition, newAxes, aspect());
  }

  @Override
  Optional<Point2> projectLocally(Vec3 point) {
    double across = Math.sqrt(point.x() * point.x() + point.z() * point.z());
    double longitude = Elementary.atan2(point.x(), point.z()) / Elementary.TWO_PI;
    double latitude = Elementary.atan2(point.y(), across) / Elementary.TWO_PI;
    return Optional.of(new Point2(longitude + .5, .5 - 2 * latitude));
  }

  @Override
  boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray) {
    double longitude = u - .5;
    double latitude = (.5 - v) / 2;
    double across = Elementary.cosTurns(latitude);
    ray.set(
        Vec3.ZERO,
        new Vec3(
            across * Elementary.sinTurns(longitude),
            Elementary.sinTurns(latitude),
            across * Elementary.cosTurns(longitude)));
    return true;
  }
}
