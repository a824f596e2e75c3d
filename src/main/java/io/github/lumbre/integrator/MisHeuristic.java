package io.github.lumbre.integrator;

import io.github.lumbre.light.Light;
import io.github.lumbre.math.sampling.internal.Mis;
import java.util.List;

/**
 * The weights of the two sampling techniques that find light: light sampling and BSDF sampling. All
 * heuristics give the same mean and differ in variance (Veach 1997, ch. 9).
 */
public enum MisHeuristic {
  /** Both techniques, weighted by the power heuristic of multiple importance sampling. */
  BOTH {
    @Override
    double lightWeight(double lightPdf, double bsdfPdf) {
      return Mis.power(lightPdf, bsdfPdf);
    }

    @Override
    double bsdfWeight(double bsdfPdf, double lightPdf) {
      return Mis.power(bsdfPdf, lightPdf);
    }
  },
  /** Both techniques, weighted by the balance heuristic. */
  BALANCE {
    @Override
    double lightWeight(double lightPdf, double bsdfPdf) {
      return Mis.balance(lightPdf, bsdfPdf);
    }

    @Override
    double bsdfWeight(double bsdfPdf, double lightPdf) {
      return Mis.balance(bsdfPdf, lightPdf);
    }
  },
  /** Light sampling alone, wherever it is possible. */
  LIGHT {
    @Override
    double lightWeight(double lightPdf, double bsdfPdf) {
      return 1;
    }

    @Override
    double bsdfWeight(double bsdfPdf, double lightPdf) {
      return lightPdf > 0 ? 0 : 1;
    }
  },
  /** BSDF sampling alone; delta lights are still sampled. */
  BSDF {
    @Override
    double lightWeight(double lightPdf, double bsdfPdf) {
      return 0;
    }

    @Override
    double bsdfWeight(double bsdfPdf, double lightPdf) {
      return 1;
    }

    @Override
    boolean samplesLights(List<Light> emitters) {
      return emitters.stream().anyMatch(Light::isDelta);
    }
  };

  /**
   * Returns the weight in [0,1] of light that light sampling found.
   *
   * @param lightPdf density of light sampling per solid angle, positive and finite
   * @param bsdfPdf density of BSDF sampling per solid angle
   */
  abstract double lightWeight(double lightPdf, double bsdfPdf);

  /**
   * Returns the weight in [0,1] of emission that a scattered ray hit.
   *
   * @param bsdfPdf density of BSDF sampling per solid angle, positive and finite
   * @param lightPdf density of light sampling per solid angle; 0 if it cannot draw this direction
   */
  abstract double bsdfWeight(double bsdfPdf, double lightPdf);

  /** Returns whether vertices sample lights at all. */
  boolean samplesLights(List<Light> emitters) {
    return !emitters.isEmpty();
  }
}
