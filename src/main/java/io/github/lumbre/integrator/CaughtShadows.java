package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Scene;

/**
 * Decides at random whether a point of a {@link ShadowCatcher} is in shadow, with the fraction of
 * the direct light that is blocked as probability.
 *
 * <p>It selects one of a few candidate light samples in proportion to the light that each would
 * give without blockers (resampled importance sampling: Talbot, Cline, Egbert 2005), and traces its
 * shadow ray. The probability is exact in the limit of many candidates, or if the sum of their
 * weights is constant. They lie on a randomly shifted rank-1 lattice, so that it varies little.
 */
final class CaughtShadows {
  /** Number of candidates. Consecutive Fibonacci numbers make a well distributed lattice. */
  private static final int CANDIDATES = 34;

  private static final int GENERATOR = 21;

  /** Irrational, so that the choices of lights are independent of the lattice. */
  private static final double CHOICE_STEP = Math.sqrt(2) - 1;

  private CaughtShadows() {}

  /**
   * Returns whether light reaches a surface that the camera ray has hit.
   *
   * @param layer how many surfaces the camera ray has passed
   */
  static boolean isLit(
      Scene scene, SurfaceHit surface, int layer, Sampler sampler, RenderContext context) {
    if (scene.emitters().isEmpty()) {
      return true;
    }
    int dimension = Sampler.caught(layer);
    Point2 shift = sampler.get2d(dimension);
    double choiceShift = sampler.get1d(dimension + 2);
    double pick = sampler.get1d(dimension + 3);
    LightSample light = context.scratch.light;
    boolean measures = context.listener.measuresShadows();
    double lit = 0;
    double total = 0;
    double before = 0;
    int picked = -1;
    for (int i = 0; i < CANDIDATES; i++) {
      sample(i, scene, surface, shift, choiceShift, light);
      double weight = weight(light, surface);
      if (weight > 0) {
        lit += measures ? arriving(scene, surface, context) : 0;
        total += weight;
        // Use the random number once more: below the limit, it is again uniform.
        double limit = weight / total;
        if (pick < limit) {
          picked = i;
          before = weight;
          pick /= limit;
        } else {
          pick = (pick - limit) / (1 - limit);
        }
      }
    }
    if (picked < 0) {
      return true;
    }
    if (measures) {
      context.listener.shadowMeasured(1 - lit / total);
    }
    sample(picked, scene, surface, shift, choiceShift, light);
    return sampler.get1d(dimension + 4) * before < arriving(scene, surface, context);
  }

  /** Returns the weight of a light sample; less behind transparent surfaces, 0 if it is blocked. */
  private static double arriving(Scene scene, SurfaceHit surface, RenderContext context) {
    return context.isOccluded(scene, surface) ? 0 : weight(context.scratch.light, surface);
  }

  private static void sample(
      int candidate,
      Scene scene,
      SurfaceHit surface,
      Point2 shift,
      double choiceShift,
      LightSample light) {
    int emitters = scene.emitters().size();
    int choice = (int) (emitters * fraction(candidate * CHOICE_STEP + choiceShift));
    Light emitter = scene.emitters().get(choice);
    Vec3 p = surface.position();
    emitter.sample(
        p.x(),
        p.y(),
        p.z(),
        fraction(candidate / (double) CANDIDATES + shift.x()),
        fraction(candidate * GENERATOR / (double) CANDIDATES + shift.y()),
        light);
  }

  private static double fraction(double x) {
    return x - Math.floor(x);
  }

  /** Returns the light that a sample gives to the side of the surface that the camera sees. */
  private static double weight(LightSample light, SurfaceHit surface) {
    if (light.isEmpty()) {
      return 0;
    }
    Vec3 normal = surface.geometricNormal();
    double cosine = light.wi().dot(normal) * (surface.isFrontal() ? 1 : -1);
    Rgb radiance = light.radiance();
    double weight = Math.max(0, cosine) * radiance.max() / (light.isDelta() ? 1 : light.pdf());
    return Double.isFinite(weight) ? weight : 0;
  }
}
