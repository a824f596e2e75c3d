package io.github.lumbre.light;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.internal.Directions;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.internal.Range;
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
    this.halfAngleDegrees = Range.above(0, 90).require("halfAngleDegrees", halfAngleDegrees);
    this.penumbraDegrees =
        Range.closed(0, halfAngleDegrees).require("penumbraDegrees", penumbraDegrees);
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

  /**
   * Returns a spotlight at a point that shines towards another, with inverse square falloff and a
   * sharp edge.
   *
   * @param intensity radiant intensity in linear RGB
   * @param halfAngleDegrees half angle of the cone in degrees, in (0, 90]
   * @throws IllegalArgumentException if the angle is out of range or the two points are the same
   */
  public static SpotLight lookingAt(
      Vec3 position, Vec3 target, Rgb intensity, double halfAngleDegrees) {
    Vec3 axis = Directions.unit("target - position", target.minus(position));
    return new SpotLight(PointLight.of(position, intensity), axis, halfAngleDegrees, 0);
  }

  /**
   * Returns this light with another soft edge.
   *
   * @param degrees width of the soft edge inside the cone, in [0, half angle]
   */
  public SpotLight withPenumbra(double degrees) {
    return new SpotLight(source, axis, halfAngleDegrees, degrees);
  }

  /** Returns the point light without the cone. */
  public PointLight source() {
    return source;
  }

  /** Returns the unit axis of the cone: the direction in which the light travels. */
  public Vec3 axis() {
    return axis;
  }

  /** Returns the half angle of the cone in degrees. */
  public double halfAngleDegrees() {
    return halfAngleDegrees;
  }

  /** Returns the width of the soft edge in degrees. */
  public double penumbraDegrees() {
    return penumbraDegrees;
  }

  @Override
  public SpotLight transformed(Transform outer) {
    Transform toWorld = outer.times(Directions.pointing(source.position(), axis));
    PointLight moved =
        new PointLight(toWorld.point(Vec3.ZERO), source.intensity(), source.falloff());
    return new SpotLight(moved, Directions.axis(toWorld), halfAngleDegrees, penumbraDegrees);
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
