package io.github.lumbre.camera;

import io.github.lumbre.camera.internal.LensRanges;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Optional;

/**
 * A fisheye camera with equidistant projection: the distance from the image center is proportional
 * to the angle from the axis. The image is a circle; film points outside have no ray.
 */
final class FishEyeCamera extends Camera {
  private final double angleDegrees;

  /**
   * Creates a camera.
   *
   * @param position the eye, in world space
   * @param axes the orthonormal world-space directions right, up and forward
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   * @param angleDegrees the full angle of view across the circle, in degrees, in (0, 360]
   * @throws IllegalArgumentException if a number is out of range
   */
  public FishEyeCamera(Vec3 position, Frame axes, double aspect, double angleDegrees) {
    super(position, axes, aspect);
    this.angleDegrees = LensRanges.FISH_EYE_ANGLE.require("angleDegrees", angleDegrees);
  }

  @Override
  public FishEyeCamera movedTo(Vec3 newPosition, Frame newAxes) {
    return new FishEyeCamera(newPosition, newAxes, aspect(), angleDegrees);
  }

  @Override
  Optional<Point2> projectLocally(Vec3 point) {
    double across = Math.sqrt(point.x() * point.x() + point.y() * point.y());
    double turns = Elementary.atan2(across, point.z()) / Elementary.TWO_PI;
    double r = turns * 720 / angleDegrees;
    if (r > 1) {
      return Optional.empty();
    }
    double x = across == 0 ? 0 : r * point.x() / across;
    double y = across == 0 ? 0 : r * point.y() / across;
    return Optional.of(
        new Point2(.5 + x / (2 * Math.max(1, aspect())), .5 - y / (2 * Math.max(1, 1 / aspect()))));
  }

  @Override
  public boolean leavesBlanks() {
    return true;
  }

  @Override
  boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray) {
    // The diameter of the circle is the shorter side of the film.
    double x = (2 * u - 1) * Math.max(1, aspect());
    double y = (1 - 2 * v) * Math.max(1, 1 / aspect());
    double r = Math.sqrt(x * x + y * y);
    if (r > 1) {
      return false;
    }
    if (r == 0) {
      ray.set(Vec3.ZERO, Vec3.Z);
      return true;
    }
    double turns = r * angleDegrees / 720;
    double s = Elementary.sinTurns(turns) / r;
    ray.set(Vec3.ZERO, new Vec3(s * x, s * y, Elementary.cosTurns(turns)));
    return true;
  }
}
