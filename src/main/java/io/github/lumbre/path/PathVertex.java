package io.github.lumbre.path;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Optional;

/**
 * One step of a recorded path: the ray, what it hits, the light found there, and how the path
 * continues. Positions and directions are in world space.
 *
 * @param branch number of the branch of a split path, from 0; 0 before the split and without one
 * @param ray that leads here, of unit direction
 * @param throughput by which light found here is multiplied
 * @param hit what the ray hits; empty if nothing
 * @param contributions the light found here, in the order in which it is added: the amounts of all
 *     vertices, added up in their order, are the sample's radiance, bit for bit
 * @param scattered the directions sampled here: none, one, or one for each branch
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
   * @param primitive its number in the scene
   * @param geometricNormal the true one, outward, of unit length
   * @param shadingNormal after interpolation and normal maps
   * @param bsdf the name of the class of its BSDF; empty if it is not shaded
   */
  public record Hit(
      int primitive, Vec3 position, Vec3 geometricNormal, Vec3 shadingNormal, String bsdf) {}

  /**
   * Light that is added to the sample in one step.
   *
   * @param lights where it comes from: one light in path mode, but all environment lights together;
   *     in ray mode all lights of a vertex
   * @param amount by which the sample grows; black if every light is blocked
   */
  public record Contribution(List<FoundLight> lights, Rgb amount) {
    public Contribution {
      lights = List.copyOf(lights);
    }
  }

  /** How light was found. */
  public enum Source {
    /** The ray hit a surface that emits. */
    EMISSION,
    /** The ray left the scene towards an environment light. */
    ENVIRONMENT,
    /** Ambient irradiance, which has no direction. */
    AMBIENT,
    /** A light was sampled. */
    LIGHT
  }

  /**
   * Light found at a vertex.
   *
   * @param emitter its index among the scene's emitters; -1 if it is none of them
   * @param wi unit direction towards it; zero for ambient light
   * @param radiance that arrives if nothing blocks it; for a delta light, irradiance at normal
   *     incidence
   * @param f f·|cos θi| for that direction; white where the ray itself found the light
   * @param lightPdf density per solid angle with which light sampling draws wi, the probability of
   *     the emitter included; for a delta light that probability; 0 if it cannot draw wi
   * @param bsdfPdf density with which BSDF sampling draws wi; infinite for a delta lobe or the
   *     camera
   * @param misWeight weight of multiple importance sampling
   * @param blocked whether something blocks it
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
    /** Returns the light that is scattered along the path, weighted; black if it is blocked. */
    public Rgb weighted() {
      if (blocked) {
        return Rgb.BLACK;
      }
      return f.times(radiance).times(source == Source.LIGHT ? misWeight / lightPdf : misWeight);
    }
  }

  /**
   * A direction in which the path continues.
   *
   * @param wi unit direction
   * @param weight f·|cos θi| / pdf
   * @param pdf per solid angle; infinite for a delta lobe
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
    /** The ray hits an emitter, which scatters nothing. */
    EMITTER,
    /** The path has reached its greatest depth. */
    DEPTH,
    /** Nothing is scattered. */
    ABSORBED,
    /** Russian roulette ended it. */
    ROULETTE
  }
}
