package io.github.lumbre.camera;

import io.github.lumbre.camera.internal.LensRanges;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Optional;

/** A perspective camera without a lens: everything is in focus. */
final class PinholeCamera extends Camera {
  private final double halfHeight;

  /**
   * Creates a camera.
   *
   * @param position the eye, in world space
   * @param axes the orthonormal world-space directions right, up and forward
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   * @param fovDegrees the full vertical angle of view, in degrees, in (0, 180)
   * @throws IllegalArgumentException if a number is out of range
   */
  public PinholeCamera(Vec3 position, Frame axes, double aspect, double fovDegrees) {
    super(position, axes, aspect);
    halfHeight = halfHeight(fovDegrees);
  }

  private PinholeCamera(PinholeCamera other, Vec3 position, Frame axes) {
    super(position, axes, other.aspect());
    halfHeight = other.halfHeight;
  }

  @Override
  public PinholeCamera movedTo(Vec3 newPosition, Frame newAxes) {
    return new PinholeCamera(this, newPosition, newAxes);
  }

  @Override
  Optional<Point2> projectLocally(Vec3 point) {
    return film(point, aspect(), halfHeight);
  }

  /** Returns the film point of a point in camera space; empty if it is not in front. */
  static Optional<Point2> film(Vec3 point, double aspect, double halfHeight) {
    return point.z() > 0
        ? Optional.of(
            new Point2(
                .5 + point.x() / (2 * aspect * halfHeight * point.z()),
                .5 - point.y() / (2 * halfHeight * point.z())))
        : Optional.empty();
  }

  @Override
  boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray) {
    ray.set(Vec3.ZERO, direction(u, v, aspect(), halfHeight));
    return true;
  }

  /** Returns the camera-space direction through a film point, with z = 1. */
  static Vec3 direction(double u, double v, double aspect, double halfHeight) {
    return new Vec3((2 * u - 1) * aspect * halfHeight, (1 - 2 * v) * halfHeight, 1);
  }

  /** Returns half the height of the film at distance 1. */
  static double halfHeight(double fovDegrees) {
    return Elementary.tanDegrees(LensRanges.FIELD_OF_VIEW.require("fovDegrees", fovDegrees) / 2);
  }
}
