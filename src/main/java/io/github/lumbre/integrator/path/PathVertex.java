package io.github.lumbre.integrator.path;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Optional;

/**
 * One vertex of a recorded path: the ray that leads to it, the hit, the light found there, and how
 * the path continues. Positions and directions are in world space; colors are linear RGB.
 *
 * @param branch number of the branch of a split path, from 0; 0 before the split and in a path that
 *     is not split
 * @param ray the ray that leads here, with a unit direction
 * @param throughput multiplies the light found here
 * @param hit the surface that the ray hits; empty if it hits nothing
 * @param contributions the light found here, in the order in which it is added; the amounts of all
 *     vertices, summed in order, are bit-identical to the sample's radiance
 * @param scattered the directions sampled here: none, one, or one per branch
 * @param end whether and why the path ends here
 */
public record PathVertex(
    int branch,
    Ray ray,
    Rgb throughput,
    Optional<Hit> hit,
    List<Contribution> contributions,
    List<Scattering> scattered,
    End end) {
  public PathVertex {
    contributions = List.copyOf(contributions);
    scattered = List.copyOf(scattered);
  }

  /**
   * The surface that a ray hits.
   *
   * @param primitive number of the primitive in the scene
   * @param position in world space
   * @param geometricNormal unit normal of the actual surface, outward
   * @param shadingNormal unit normal after interpolation and normal maps
   * @param bsdf class name of the BSDF; empty if the surface is not shaded
   */
  public record Hit(
      int primitive, Vec3 position, Vec3 geometricNormal, Vec3 shadingNormal, String bsdf) {}

  /**
   * Light that is added to the sample in one step.
   *
   * @param lights the lights it comes from. In path mode this is one light, or all environment
   *     lights together; in ray mode, all lights sampled at a vertex
   * @param amount the amount added to the sample; black if every light is blocked
   */
  public record Contribution(List<FoundLight> lights, Rgb amount) {
    public Contribution {
      lights = List.copyOf(lights);
    }
  }

  /** How a light was found. */
  public enum Source {
    /** The ray hit a surface that emits. */
    EMISSION,
    /** The ray left the scene towards an environment light. */
    ENVIRONMENT,
    /** Ambient irradiance, which has no direction. */
    AMBIENT,
    /** A light was sampled. */
    LIGHT,
    /** A light out of focus was sampled through the lens, beside the camera ray. */
    LENS,
    /** The reflection of a light in a mirror was sampled. */
    MIRROR,
    /** A light was sampled through clear glass that refracts it. */
    REFRACTION;

    private boolean isSampled() {
      return this == LIGHT || this == LENS || this == MIRROR || this == REFRACTION;
    }
  }

  /**
   * Light found at a vertex.
   *
   * @param source how the light was found
   * @param emitter index of the light among the scene's emitters; -1 if it is none of them
   * @param wi unit direction towards the light, or towards the surface that mirrors or refracts it;
   *     zero for ambient light; through the lens, from where the rays of the film point cross
   * @param radiance radiance that arrives, mirrored or refracted, if nothing blocks it; for a delta
   *     light, irradiance at normal incidence
   * @param f f·|cos θi| for that direction; white if the ray itself hit the light; through the
   *     lens, the density with which a random lens point draws the direction
   * @param lightPdf density per solid angle with which light sampling draws wi, times the
   *     probability of selecting the emitter; for a delta light, that probability alone; 0 if light
   *     sampling cannot draw wi
   * @param bsdfPdf density per solid angle with which BSDF sampling, or a random lens point, draws
   *     wi, times the probability of being refracted after it; infinite for a delta lobe, or the
   *     camera if no light is sampled through its lens
   * @param misWeight weight of multiple importance sampling, in [0,1]
   * @param blocked whether something blocks the light
   */
  public record FoundLight(
      Source source,
      int emitter,
      Vec3 wi,
      Rgb radiance,
      Rgb f,
      double lightPdf,
      double bsdfPdf,
      double misWeight,
      boolean blocked) {
    /**
     * Returns the light that is scattered along the path, with its MIS weight and before the
     * throughput; black if it is blocked.
     */
    public Rgb weighted() {
      if (blocked) {
        return Rgb.BLACK;
      }
      return f.times(radiance).times(source.isSampled() ? misWeight / lightPdf : misWeight);
    }
  }

  /**
   * A direction sampled at a vertex, in which the path continues if it survives.
   *
   * @param wi unit direction
   * @param weight f·|cos θi| / pdf
   * @param pdf density per solid angle; infinite for a delta lobe
   * @param survival probability with which Russian roulette continues the path; 1 without it
   * @param survives whether the path continues
   */
  public record Scattering(Vec3 wi, Rgb weight, double pdf, double survival, boolean survives) {}

  /** Whether and why a path ends. */
  public enum End {
    /** It continues; in ray mode, with one ray or several. */
    CONTINUES,
    /** It is split into branches. */
    SPLIT,
    /** The ray hits nothing. */
    ESCAPED,
    /** The ray hits an emitter; emitters scatter no light. */
    EMITTER,
    /** The path has reached its greatest depth. */
    DEPTH,
    /** The surface scatters no light. */
    ABSORBED,
    /** Russian roulette ended it. */
    ROULETTE
  }
}
