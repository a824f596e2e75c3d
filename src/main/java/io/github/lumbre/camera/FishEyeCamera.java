package io.github.lumbre.camera;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;

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
  boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray) {
    // The circle touches the shorter pair of the film's sides.
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
