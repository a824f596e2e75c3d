package io.github.lumbre.camera;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import java.util.Optional;

/** Perspective without a lens: everything is in focus. */
public final class PinholeCamera extends Camera {
  private final double halfHeight;

  /**
   * @param fovDegrees full vertical angle of view, in (0, 180)
   */
  public PinholeCamera(Vec3 position, Frame axes, double aspect, double fovDegrees) {
    super(position, axes, aspect);
    halfHeight = halfHeight(fovDegrees);
  }

  @Override
  Optional<Ray> localRay(Point2 film, Sampler sampler) {
    return Optional.of(new Ray(Vec3.ZERO, direction(film, aspect(), halfHeight)));
  }

  /** Returns the direction through a film point at distance 1; not of unit length. */
  static Vec3 direction(Point2 film, double aspect, double halfHeight) {
    return new Vec3((2 * film.x() - 1) * aspect * halfHeight, (1 - 2 * film.y()) * halfHeight, 1);
  }

  /** Returns half the height of the film at distance 1. */
  static double halfHeight(double fovDegrees) {
    if (!(fovDegrees > 0 && fovDegrees < 180)) {
      throw new IllegalArgumentException("fovDegrees: expected in (0, 180), found " + fovDegrees);
    }
    return Elementary.tanDegrees(fovDegrees / 2);
  }
}
