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
  };

  /** Returns the irradiance at normal incidence. */
  abstract Rgb irradiance(Rgb intensity, double distanceSquared);
}
