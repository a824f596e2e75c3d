package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.scene.Scene;

/**
 * Finds the surface where a ray scatters in a scene with partly transparent surfaces. At each of
 * them, the ray passes at random with a probability that its transmittance gives, and the factor by
 * which the path's throughput changes keeps the mean. Mutable; each thread reuses one instance.
 */
final class Passing {
  /** A ray that passes more surfaces ends. */
  static final int MAX_LAYERS = 255;

  private double red, green, blue;
  private long rays;

  /**
   * Moves a hit that {@link Scene#intersect} has found to the first surface that stops the ray.
   *
   * @param vertex number of the path's next vertex
   * @return whether there is one
   */
  boolean stops(Scene scene, NearestHit hit, int vertex, Sampler sampler) {
    red = 1;
    green = 1;
    blue = 1;
    rays = 0;
    for (int layer = 0; layer <= MAX_LAYERS; layer++) {
      Material material = scene.primitiveAt(hit).material();
      if (material.isOpaque()) {
        return true;
      }
      SurfaceHit surface = scene.surfaceAt(hit);
      Rgb passed = material.transmittance(surface);
      double probability = Math.min(1, passed.max());
      if (sampler.get1d(Sampler.passing(vertex, layer)) >= probability) {
        scale(1 / (1 - probability), 1 / (1 - probability), 1 / (1 - probability));
        return true;
      }
      scale(passed.r() / probability, passed.g() / probability, passed.b() / probability);
      Vec3 direction = hit.direction();
      surface.spawn(direction.x(), direction.y(), direction.z(), hit);
      rays++;
      if (!scene.intersect(hit)) {
        return false;
      }
    }
    scale(0, 0, 0);
    return true;
  }

  private void scale(double r, double g, double b) {
    red *= r;
    green *= g;
    blue *= b;
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
