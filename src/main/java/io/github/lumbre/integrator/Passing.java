package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Scene;

/**
 * Finds the surface where a ray scatters in a scene with partly transparent surfaces or absorbing
 * media. At each transparent surface, the ray passes at random with a probability that its
 * transmittance gives, and the factor by which the path's throughput changes keeps the mean. A
 * medium absorbs along the ray up to the back of its boundary. A transparent surface that coincides
 * with the one which the ray leaves is behind it. Mutable; each thread reuses one instance.
 */
final class Passing {
  /** The sample of a ray that would pass more surfaces is rejected. */
  static final int MAX_LAYERS = 1 << 16;

  private double red, green, blue;
  private long rays;

  /**
   * Moves the context's hit, which {@link Scene#intersect} has found, to the first surface that
   * stops the ray.
   *
   * @param vertex number of the path's next vertex
   * @return whether there is one
   */
  boolean stops(Scene scene, int vertex, Sampler sampler, RenderContext context) {
    NearestHit hit = context.hit;
    red = 1;
    green = 1;
    blue = 1;
    rays = 0;
    double mediumStart = 0;
    for (int layer = 0; ; layer++) {
      Material material = scene.primitiveAt(hit).material();
      boolean endsMedium = !material.absorption().isBlack();
      if (material.isOpaque() && !endsMedium) {
        return true;
      }
      SurfaceHit surface = scene.surfaceAt(hit);
      if (endsMedium) {
        scale(absorbed(material, surface, hit.t() - mediumStart));
        mediumStart = hit.t();
        context.passedGlass |= vertex == 0 && !surface.isFrontal();
      }
      if (material.isOpaque()) {
        return true;
      }
      if (layer == MAX_LAYERS) {
        scale(Rgb.BLACK);
        context.isRejected = true;
        return true;
      }
      boolean isLeft = surface.isAtOriginOf(hit);
      if (!isLeft && material.catchesShadows() && vertex == 0) {
        if (!CaughtShadows.isLit(scene, surface, layer, sampler, context)) {
          scale(Rgb.BLACK);
          return true;
        }
        context.listener.litGroundPassed(surface);
      } else if (!isLeft
          && !passes(material, surface, sampler.get1d(Sampler.passing(vertex, layer)))) {
        return true;
      }
      context.passedGlass |= vertex == 0 && !isLeft && material.passesThroughGlass(surface);
      hit.pass();
      rays++;
      if (!scene.intersect(hit)) {
        return false;
      }
    }
  }

  private boolean passes(Material material, SurfaceHit surface, double random) {
    Rgb passed = material.transmittance(surface);
    double probability = Math.min(1, passed.max());
    if (random >= probability) {
      scale(Rgb.gray(1 / (1 - probability)));
      return false;
    }
    scale(passed.times(1 / probability));
    return true;
  }

  private void scale(Rgb factor) {
    red *= factor.r();
    green *= factor.g();
    blue *= factor.b();
  }

  /**
   * Returns the fraction of light that the medium behind a surface leaves over a distance, if the
   * ray comes from there (Beer 1852; PBRT 4e, sec. 11.2); white if it comes from the front.
   */
  static Rgb absorbed(Material material, SurfaceHit surface, double length) {
    Rgb absorption = material.absorption();
    return absorption.isBlack() || surface.isFrontal()
        ? Rgb.WHITE
        : new Rgb(
            Elementary.exp(-absorption.r() * length),
            Elementary.exp(-absorption.g() * length),
            Elementary.exp(-absorption.b() * length));
  }

  /** Returns whether rays of a scene pass surfaces or media, so that {@link #stops} is needed. */
  static boolean isNeeded(Scene scene) {
    return scene.hasTransparency()
        || scene.primitives().stream().anyMatch(p -> !p.material().absorption().isBlack());
  }

  /** Returns the red factor of the throughput. */
  double red() {
    return red;
  }

  /** Returns the green factor of the throughput. */
  double green() {
    return green;
  }

  /** Returns the blue factor of the throughput. */
  double blue() {
    return blue;
  }

  /** Returns the factor of the throughput. */
  Rgb factor() {
    return new Rgb(red, green, blue);
  }

  /** Returns the number of further rays that were traced. */
  long rays() {
    return rays;
  }
}
