package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.integrator.path.PathVertex.End;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.scene.Scene;

/**
 * Receives the events of a path while an {@link Integrator} traces it.
 *
 * <p>An event allocates nothing: its arguments are plain numbers and objects that the {@link
 * RenderContext} reuses. Such an object is valid only during the call. A listener that ignores an
 * event does not implement it.
 *
 * <p>Colors are linear RGB, passed as three components; only the red one is documented.
 */
interface PathListener {
  /** Ignores all events. */
  PathListener NONE = new PathListener() {};

  /** A path starts at the camera. */
  default void pathStarted() {}

  /**
   * A ray was traced from the camera, or from the vertex where the path last scattered.
   *
   * @param ray origin and unit direction in world space, and the nearest hit if there is one
   * @param depth number of surfaces that scattered the path so far
   * @param r red component of the throughput, which multiplies the light found next
   */
  default void rayTraced(NearestHit ray, int depth, double r, double g, double b) {}

  /** The ray from the camera passes a lit point of a surface that shows only its shadows. */
  default void litGroundPassed(SurfaceHit surface) {}

  /** Returns whether {@link #shadowMeasured} is wanted. */
  default boolean measuresShadows() {
    return false;
  }

  /**
   * The camera ray meets a ground that shows its shadow alone, before it passes or not.
   *
   * @param blocked the part of the direct light that is blocked there, in [0,1]
   */
  default void shadowMeasured(double blocked) {}

  /**
   * The ray hit a surface that is not shaded, because it emits or because the path has reached its
   * greatest depth.
   *
   * @param ray with its nearest hit; {@link Scene#surfaceAt} returns the hit surface
   */
  default void surfaceHit(NearestHit ray, Scene scene) {}

  /** The ray hit a surface that scatters. */
  default void vertexReached(int primitive, SurfaceHit surface, Bsdf bsdf) {}

  /**
   * A light was sampled at the vertex, through the lens, or by way of a specular surface.
   *
   * @param source the way in which it was sampled
   * @param emitter index among the scene's emitters
   * @param value f·|cos θi| and density of the BSDF for the light's direction
   * @param lightPdf density of the sample per solid angle, times the probability of selecting the
   *     emitter; for a delta light, that probability alone
   * @param misWeight weight of multiple importance sampling
   * @param blocked whether the shadow ray hit something
   */
  default void lightSampled(
      Source source,
      int emitter,
      LightSample light,
      BsdfValue value,
      double lightPdf,
      double misWeight,
      boolean blocked) {}

  /**
   * The ray hit light without light sampling, or the vertex receives ambient light.
   *
   * @param emitter index among the scene's emitters; -1 if it is none of them
   * @param r red component of the radiance, unweighted
   * @param lightPdf density per solid angle with which light sampling would have drawn the ray; 0
   *     if it cannot
   * @param bsdfPdf density per solid angle with which the ray was drawn; infinite for delta lobes
   *     and the camera
   * @param misWeight weight of multiple importance sampling
   */
  default void lightFound(
      Source source,
      int emitter,
      double r,
      double g,
      double b,
      double lightPdf,
      double bsdfPdf,
      double misWeight) {}

  /**
   * Light is added to the sample. The light comes from the lights reported since the last such
   * event.
   *
   * @param r red component of the light after MIS weighting, before multiplication by the
   *     throughput
   */
  default void lightAdded(double r, double g, double b) {}

  /**
   * A direction was sampled at the vertex. If it does not survive Russian roulette, the path ends.
   *
   * @param sample not absorbed
   * @param survival probability with which Russian roulette continues the path; 1 without it
   * @param survives whether the path continues
   */
  default void scattered(BsdfSample sample, double survival, boolean survives) {}

  /** A branch of a split path starts at the vertex where the path was split. */
  default void branchStarted(int branch) {}

  /** The path ends, or is split, where the last ray led. */
  default void pathEnded(End end) {}
}
