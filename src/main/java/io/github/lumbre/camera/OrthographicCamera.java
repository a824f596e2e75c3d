package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Optional;

/**
 * A camera with parallel projection: all rays have the direction of its view, and the size of an
 * object in the picture does not depend on its distance.
 */
final class OrthographicCamera extends Camera {
  private final double halfHeight;

  /**
   * Creates a camera.
   *
   * @param position the center of the film, in world space; surfaces behind it are invisible
   * @param axes the orthonormal world-space directions right, up and forward
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   * @param height the height of the film, in world units, &gt; 0 and finite
   * @throws IllegalArgumentException if a number is out of range
   */
  public OrthographicCamera(Vec3 position, Frame axes, double aspect, double height) {
    super(position, axes, aspect);
    halfHeight = .5 * Range.POSITIVE.require("height", height);
  }

  private OrthographicCamera(OrthographicCamera other, Vec3 position, Frame axes) {
    super(position, axes, other.aspect());
    halfHeight = other.halfHeight;
  }

  @Override
  public OrthographicCamera movedTo(Vec3 newPosition, Frame newAxes) {
    return new OrthographicCamera(this, newPosition, newAxes);
  }

  @Override
  Optional<Point2> projectLocally(Vec3 point) {
    return point.z() > 0
        ? Optional.of(
            new Point2(
                .5 + point.x() / (2 * aspect() * halfHeight), .5 - point.y() / (2 * halfHeight)))
        : Optional.empty();
  }

  @Override
  boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray) {
    ray.set(new Vec3((2 * u - 1) * aspect() * halfHeight, (1 - 2 * v) * halfHeight, 0), Vec3.Z);
    return true;
  }
}
