package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Optional;

/**
 * One step of a recorded path: the ray, what it meets, what light is gathered there, and how the
 * path goes on.
 *
 * @param ray that leads here, of unit direction
 * @param throughput what light that is gathered here counts for
 * @param meeting what the ray meets; empty if nothing
 * @param gathered the light found here, in the order in which it is added
 * @param scattering where the path goes on; empty if it was not asked, or several ways at once
 * @param end whether and why the path ends here
 * @param sum all that the path has gathered so far; of the last vertex, the sample's radiance
 */
public record PathVertex(
    Ray ray,
    Rgb throughput,
    Optional<Meeting> meeting,
    List<Gathered> gathered,
    Optional<Scattering> scattering,
    End end,
    Rgb sum) {
  public PathVertex {
    gathered = List.copyOf(gathered);
  }

  /**
   * The surface that a ray meets.
   *
   * @param primitive its number in the scene
   * @param position in the world
   * @param geometricNormal the true one, outward, of unit length
   * @param shadingNormal after interpolation and normal maps
   * @param bsdf how it scatters there, by the name of its class; empty if it glows
   */
  public record Meeting(
      int primitive, Vec3 position, Vec3 geometricNormal, Vec3 shadingNormal, String bsdf) {}

  /** How light was found. */
  public enum Source {
    /** The ray met what glows. */
    EMISSION,
    /** The ray left the scene for a dome or the background. */
    BACKGROUND,
    /** From nowhere in particular. */
    AMBIENT,
    /** An emitter was asked. */
    LIGHT
  }

  /**
   * Light found at a vertex.
   *
   * @param emitter its number among the scene's emitters; -1 if it is none of them, or several
   * @param wi unit direction to where it comes from
   * @param radiance that arrives, of a light of no size the irradiance at normal incidence, if
   *     nothing is in between
   * @param f f·|cos θi| for that direction; white where light meets the ray itself
   * @param lightPdf density per solid angle with which light sampling draws wi, the choice of the
   *     emitter included; of a light of no size the probability of that choice; 0 if it cannot
   * @param bsdfPdf density with which scattering draws wi; infinite if light sampling cannot
   * @param weight of multiple importance sampling
   * @param blocked whether something is in between
   * @param contribution to the sample: black if blocked
   */
  public record Gathered(
      Source source,
      int emitter,
      Vec3 wi,
      Rgb radiance,
      Rgb f,
      double lightPdf,
      double bsdfPdf,
      double weight,
      boolean blocked,
      Rgb contribution) {}

  /**
   * How a path goes on.
   *
   * @param wi unit direction
   * @param weight f·|cos θi| / pdf
   * @param pdf per solid angle; infinite of a mirror-like lobe
   * @param survival probability of going on; 1 if it was not left to chance
   */
  public record Scattering(Vec3 wi, Rgb weight, double pdf, double survival) {}

  /** Whether and why a path ends. */
  public enum End {
    /** It goes on, in ray mode or where it is split perhaps in several ways. */
    GOES_ON,
    /** The ray meets nothing. */
    ESCAPED,
    /** The ray meets what glows, which scatters nothing. */
    EMITTER,
    /** The path has as many vertices as it may. */
    DEPTH,
    /** Nothing is scattered. */
    ABSORBED,
    /** Roulette ended it. */
    ROULETTE
  }
}
