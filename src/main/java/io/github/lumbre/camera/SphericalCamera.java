package io.github.lumbre.camera;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;

/** All directions, 360° by 180°, in equal steps of longitude and latitude; the centre is +z. */
public final class SphericalCamera extends Camera {
  public SphericalCamera(Vec3 position, Frame axes, double aspect) {
    super(position, axes, aspect);
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
