package io.github.lumbre.camera;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import java.util.Optional;

/** All directions, 360° by 180°, in equal steps of longitude and latitude; the centre is +z. */
public final class SphericalCamera extends Camera {
  public SphericalCamera(Vec3 position, Frame axes, double aspect) {
    super(position, axes, aspect);
  }

  @Override
  Optional<Ray> localRay(Point2 film, Sampler sampler) {
    double longitude = film.x() - .5;
    double latitude = (.5 - film.y()) / 2;
    double across = Elementary.cosTurns(latitude);
    return Optional.of(
        new Ray(
            Vec3.ZERO,
            new Vec3(
                across * Elementary.sinTurns(longitude),
                Elementary.sinTurns(latitude),
                across * Elementary.cosTurns(longitude))));
  }
}
