package io.github.lumbre.camera;

import io.github.lumbre.camera.internal.LensRanges;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Optional;

/** A 360° panorama on an upright cylinder. The center of the film looks along +z. */
final class CylindricalCamera extends Camera {
  /** Above this, squares of directions overflow. */

  private final double halfHeight;

  /**
   * Creates a camera.
   *
   * @param position the eye, in world space
   * @param axes the orthonormal world-space directions right, up and forward
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   * @param halfHeight half the height of the film on the unit cylinder, in [0, 1e150]
   * @throws IllegalArgumentException if a number is out of range
   */
  public CylindricalCamera(Vec3 position, Frame axes, double aspect, double halfHeight) {
    super(position, axes, aspect);
    this.halfHeight = LensRanges.CYLINDER_HEIGHT.require("halfHeight", halfHeight);
  }

  private CylindricalCamera(CylindricalCamera other, Vec3 position, Frame axes) {
    super(position, axes, other.aspect());
    halfHeight = other.halfHeight;
  }

  @Override
  public CylindricalCamera movedTo(Vec3 newPosition, Frame newAxes) {
    return new CylindricalCamera(this, newPosition, newAxes);
  }

  @Override
  Optional<Point2> projectLocally(Vec3 point) {
    double radius = Math.sqrt(point.x() * point.x() + point.z() * point.z());
    double turns = Elementary.atan2(point.x(), point.z()) / Elementary.TWO_PI;
    return Optional.of(new Point2(turns + .5, .5 - point.y() / (2 * radius * halfHeight)));
  }

  @Override
  boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray) {
    double turns = u - .5;
    ray.set(
        Vec3.ZERO,
        new Vec3(Elementary.sinTurns(turns), (1 - 2 * v) * halfHeight, Elementary.cosTurns(turns)));
    return true;
  }
}
