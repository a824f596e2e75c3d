package io.github.lumbre.light;

import io.github.lumbre.image.Rgb;

/** How the light of a point-like source depends on distance. */
public enum Falloff {
  /** Not at all: the intensity is the irradiance at normal incidence at any distance. */
  NONE {
    @Override
    Rgb irradiance(Rgb intensity, double distanceSquared) {
      return intensity;
    }

    @Override
    double sphere(double sceneRadius) {
      // As parallel light that covers the scene.
      return Math.PI * sceneRadius * sceneRadius;
    }
  },

  /** Physically: the intensity is radiant intensity, power per solid angle. */
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

  /** Returns the irradiance at normal incidence. */
  abstract Rgb irradiance(Rgb intensity, double distanceSquared);

  /** Returns about what an intensity of 1 in all directions sends into a scene. */
  abstract double sphere(double sceneRadius);
}
