package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.math.sampling.Sampler;

/**
 * A way to sample the light of a path, in addition to rays that meet it by themselves. Multiple
 * importance sampling weights the two against each other (Veach 1997, ch. 9). Immutable.
 */
interface LightTechnique {
  /**
   * Samples light for the path's last vertex, or for its camera ray, and adds the light.
   *
   * @param depth number of the vertex, from 0
   */
  void add(int depth, Sampler sampler, RenderContext context);

  /**
   * Returns whether this technique is the one that might also have found a light that the path's
   * last ray meets.
   *
   * @param depth number of surfaces that scattered the path
   */
  boolean mightFind(int depth, RenderContext context);

  /**
   * Returns the density per solid angle with which the path was drawn where this technique might
   * have found the light.
   */
  double rayPdf(RenderContext context);

  /**
   * Returns the density per solid angle, at the same place, with which {@link #add} draws a light;
   * 0 if it cannot.
   *
   * @param emitter index among the scene's emitters
   * @param hit where the path's last ray meets the light
   */
  double pdf(int emitter, SurfaceHit hit, RenderContext context);
}
