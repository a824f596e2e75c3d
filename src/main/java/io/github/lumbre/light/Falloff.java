package io.github.lumbre.light;

import io.github.lumbre.image.Rgb;

/** How the irradiance from a point light or spotlight depends on distance. */
public enum Falloff {
  /** No falloff: the light's intensity is the irradiance at normal incidence at any distance. */
  NONE {
    @Override
    Rgb irradiance(Rgb intensity, double distanceSquared) {
      return intensity;
    }

    @Override
    double sphere(double sceneRadius) {
      // The power of parallel light that covers the scene.
      return Math.PI * sceneRadius * sceneRadius;
    }
  },

  /**
   * Inverse-square falloff: the light's intensity is radiant intensity, in power per solid angle.
   */
  INVERSE_SQUARE {
    @Override
    Rgb irradiance(Rgb intensity, double distanceSquared) {
      return new Rgb(
          intensity.r() / distanceSquared,
          intensity.g() / distanceSquared,
          intensity.b() / distanceSquared);
    }

    @Override
    double sphere(double sceneRadius) {
      return 4 * Math.PI;
    }
  };

  /** Returns the irradiance at normal incidence at a squared distance &gt; 0. */
  abstract Rgb irradiance(Rgb intensity, double distanceSquared);

  /**
   * Returns an estimate of the power that a light of intensity 1 in all directions sends into a
   * scene of the given radius.
   */
  abstract double sphere(double sceneRadius);
}
