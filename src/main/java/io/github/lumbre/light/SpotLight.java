package io.github.lumbre.light;

import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Vec3;
import java.util.Objects;
import java.util.Optional;

/** A spotlight: a point light restricted to a cone with a sharp or soft edge. Immutable. */
public final class SpotLight implements Light {
  private final PointLight source;
  private final Vec3 axis;
  private final double halfAngleDegrees;
  private final double penumbraDegrees;
  private final double cosOuter;
  private final double sinOuter;

  /**
   * Creates a spotlight.
   *
   * @param source the point light without the cone
   * @param axis unit axis of the cone, the direction in which the light travels, in world space
   * @param halfAngleDegrees half angle of the cone in degrees, in (0, 90]
   * @param penumbraDegrees width of the soft edge inside the cone in degrees, in [0,
   *     halfAngleDegrees]
   * @throws IllegalArgumentException if an angle is out of range
   */
  public SpotLight(PointLight source, Vec3 axis, double halfAngleDegrees, double penumbraDegrees) {
    this.source = Objects.requireNonNull(source, "source");
    this.axis = Objects.requireNonNull(axis, "axis");
    if (!(halfAngleDegrees > 0 && halfAngleDegrees <= 90)) {
      throw new IllegalArgumentException(
          "halfAngleDegrees: expected in (0, 90], found " + halfAngleDegrees);
    }
    if (!(penumbraDegrees >= 0 && penumbraDegrees <= halfAngleDegrees)) {
      throw new IllegalArgumentException(
          "penumbraDegrees: expected in [0, " + halfAngleDegrees + "], found " + penumbraDegrees);
    }
    this.halfAngleDegrees = halfAngleDegrees;
    this.penumbraDegrees = penumbraDegrees;
    cosOuter = Elementary.cosDegrees(halfAngleDegrees);
    sinOuter = Elementary.sinDegrees(halfAngleDegrees);
  }

  @Override
  public void sample(double x, double y, double z, double u, double v, LightSample result) {
    source.sample(x, y, z, u, v, result);
    result.dim(share(result.wi().cross(axis).length(), -result.wi().dot(axis)));
  }

  private double share(double sinAngle, double cosAngle) {
    // Compare by the sine of the difference of the angles: cosines in narrow cones are all nearly
    // 1.
    if (sinAngle * cosOuter - cosAngle * sinOuter > 0) {
      return 0;
    }
    if (penumbraDegrees == 0) {
      return 1;
    }
    double angle = Math.toDegrees(Elementary.atan2(sinAngle, cosAngle));
    double s = Math.max(0, Math.min(1, (halfAngleDegrees - angle) / penumbraDegrees));
    return s * s * (3 - 2 * s);
  }

  @Override
  public double power(double sceneRadius) {
    double shareOfSphere = .5 * (1 - Elementary.cosDegrees(halfAngleDegrees));
    return source.power(sceneRadius) * shareOfSphere;
  }

  @Override
  public Optional<LightBounds> bounds() {
    double sharp = Math.toRadians(halfAngleDegrees - penumbraDegrees);
    double soft = Math.toRadians(penumbraDegrees);
    return source
        .bounds()
        .map(all -> LightBounds.towards(all.box(), axis, sharp, soft, all.intensity()));
  }

  @Override
  public double farIrradiance() {
    return source.farIrradiance();
  }

  @Override
  public boolean isBlack() {
    return source.isBlack();
  }
}
