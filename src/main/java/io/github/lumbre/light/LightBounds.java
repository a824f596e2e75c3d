package io.github.lumbre.light;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/**
 * Bounds of the light of one or more emitters: of its origin, its directions and its approximate
 * intensity. The bounds of origin and direction are conservative.
 *
 * <p>Conty Estevez &amp; Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree
 * Splitting", sec. 4.1.
 *
 * @param box bounding box of the emitters, in world space
 * @param axis unit axis of the cone that contains all emitter normals
 * @param spread half angle of that cone in radians, in [0, π]; π for a point light
 * @param fall largest angle in radians between a normal and emitted light, in [0, π/2] for surfaces
 * @param intensity approximate radiant intensity in the brightest direction, using the largest
 *     color component
 */
public record LightBounds(Bounds3 box, Vec3 axis, double spread, double fall, double intensity) {
  /** Margin in radians for rounding errors of angles; slightly wider cones do no harm. */
  private static final double MARGIN = 1e-9;

  /** Returns bounds of emitters in a box that emit in all directions. */
  public static LightBounds allAround(Bounds3 box, double intensity) {
    return new LightBounds(box, Vec3.Z, Math.PI, .5 * Math.PI, intensity);
  }

  /** Returns bounds of emitters in a box whose light stays within a cone. */
  public static LightBounds towards(
      Bounds3 box, Vec3 axis, double spread, double fall, double intensity) {
    return new LightBounds(box, axis, spread + MARGIN, fall + MARGIN, intensity);
  }

  /** Returns whether all emitters face the direction of the axis and emit nothing backwards. */
  public boolean isFlat() {
    return spread <= 2 * MARGIN && fall <= .5 * Math.PI + 2 * MARGIN;
  }

  /** Returns the same bounds with another intensity. */
  public LightBounds withIntensity(double value) {
    return new LightBounds(box, axis, spread, fall, value);
  }

  /** Returns bounds of the emitters of both operands. */
  public LightBounds union(LightBounds o) {
    LightBounds wide = spread >= o.spread ? this : o;
    LightBounds narrow = spread >= o.spread ? o : this;
    Bounds3 bothBoxes = box.union(o.box);
    double bothFalls = Math.max(fall, o.fall);
    double sum = intensity + o.intensity;
    double between =
        Elementary.atan2(wide.axis.cross(narrow.axis).length(), wide.axis.dot(narrow.axis));
    if (between + narrow.spread <= wide.spread) {
      return new LightBounds(bothBoxes, wide.axis, wide.spread, bothFalls, sum);
    }
    double half = .5 * (wide.spread + between + narrow.spread) + MARGIN;
    Vec3 across = narrow.axis.plus(-narrow.axis.dot(wide.axis), wide.axis);
    if (half >= Math.PI || !(across.length() > MARGIN)) {
      return new LightBounds(bothBoxes, wide.axis, Math.PI, bothFalls, sum);
    }
    double turns = (half - wide.spread) / Elementary.TWO_PI;
    Vec3 middle =
        wide.axis
            .times(Elementary.cosTurns(turns))
            .plus(Elementary.sinTurns(turns), across.normalized());
    return new LightBounds(bothBoxes, middle.normalized(), half, bothFalls, sum);
  }

  /**
   * Returns the cost of treating the emitters as one: the product of intensity, solid angle and
   * squared radius of the box.
   */
  public double cost() {
    double radius = box.radius();
    double reach = Math.min(spread + fall, Math.PI);
    double sinSpread = Elementary.sinTurns(spread / Elementary.TWO_PI);
    double cosSpread = Elementary.cosTurns(spread / Elementary.TWO_PI);
    double solidAngle =
        Elementary.TWO_PI * (1 - cosSpread)
            + .5
                * Math.PI
                * (2 * (reach - spread) * sinSpread
                    - Elementary.cosTurns((spread - 2 * reach) / Elementary.TWO_PI)
                    + cosSpread);
    return intensity * solidAngle * radius * radius;
  }
}
