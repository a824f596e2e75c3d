package io.github.lumbre.light;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Elementary;
import io.github.lumbre.math.Vec3;

/**
 * Where the light of one or more emitters comes from, where it goes and about how much there is:
 * never less in place and direction than is true.
 *
 * <p>Conty Estevez &amp; Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree
 * Splitting", sec. 4.1.
 *
 * @param box around all that shines
 * @param axis unit axis of the cone that holds all normals
 * @param spread half angle of that cone, in [0, π]; for a point light π
 * @param fall how far from a normal light goes, in [0, π/2] for surfaces
 * @param intensity radiant intensity in the strongest direction, by the strongest colour component
 */
public record LightBounds(Bounds3 box, Vec3 axis, double spread, double fall, double intensity) {
  /** For the rounding of angles; wider cones cost nothing. */
  private static final double MARGIN = 1e-9;

  /** Returns the bounds of what shines from a box in all directions. */
  static LightBounds allAround(Bounds3 box, double intensity) {
    return new LightBounds(box, Vec3.Z, Math.PI, .5 * Math.PI, intensity);
  }

  /** Returns the bounds of a cone of light. */
  static LightBounds towards(Bounds3 box, Vec3 axis, double spread, double fall, double intensity) {
    return new LightBounds(box, axis, spread + MARGIN, fall + MARGIN, intensity);
  }

  LightBounds withIntensity(double value) {
    return new LightBounds(box, axis, spread, fall, value);
  }

  /** Returns the bounds of the emitters of both. */
  LightBounds union(LightBounds o) {
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

  /** Returns how bad it is to be treated as one: intensity, size and solid angle together. */
  double cost() {
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
