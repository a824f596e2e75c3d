package io.github.lumbre.camera;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import java.util.Optional;

/**
 * A circle in which the distance from the centre is proportional to the angle from the axis
 * (equidistant projection). Outside the circle nothing is imaged.
 */
public final class FishEyeCamera extends Camera {
  private final double angleDegrees;

  /**
   * @param angleDegrees full angle from rim to rim, in (0, 360]
   */
  public FishEyeCamera(Vec3 position, Frame axes, double aspect, double angleDegrees) {
    super(position, axes, aspect);
    if (!(angleDegrees > 0 && angleDegrees <= 360)) {
      throw new IllegalArgumentException(
          "angleDegrees: expected in (0, 360], found " + angleDegrees);
    }
    this.angleDegrees = angleDegrees;
  }

  @Override
  public boolean leavesBlanks() {
    return true;
  }

  @Override
  Optional<Ray> localRay(Point2 film, Sampler sampler) {
    // The circle touches the shorter pair of the film's sides.
    double x = (2 * film.x() - 1) * Math.max(1, aspect());
    double y = (1 - 2 * film.y()) * Math.max(1, 1 / aspect());
    double r = Math.sqrt(x * x + y * y);
    if (r > 1) {
      return Optional.empty();
    }
    if (r == 0) {
      return Optional.of(new Ray(Vec3.ZERO, Vec3.Z));
    }
    double turns = r * angleDegrees / 720;
    double s = Elementary.sinTurns(turns) / r;
    return Optional.of(new Ray(Vec3.ZERO, new Vec3(s * x, s * y, Elementary.cosTurns(turns))));
  }
}
