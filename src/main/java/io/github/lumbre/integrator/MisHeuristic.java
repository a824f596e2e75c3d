package io.github.lumbre.integrator;

import io.github.lumbre.light.Light;
import io.github.lumbre.sampling.Mis;
import java.util.List;

/**
 * Which of two ways to find an emitter counts how much: asking it for light, or meeting it with a
 * scattered ray. All have the same mean and differ in variance (Veach 1997, ch. 9).
 */
public enum MisHeuristic {
  /** Both, by the power heuristic of multiple importance sampling. */
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
  /** Both, by the balance heuristic. */
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
  /** Light sampling alone, where it is possible. */
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
   * Returns the weight of light found by light sampling.
   *
   * @param lightPdf of asking for it, positive and finite
   * @param bsdfPdf of meeting it
   */
  abstract double lightWeight(double lightPdf, double bsdfPdf);

  /**
   * Returns the weight of an emitter that a scattered ray has met.
   *
   * @param bsdfPdf of meeting it, positive and finite
   * @param lightPdf of asking for it
   */
  abstract double bsdfWeight(double bsdfPdf, double lightPdf);

  /** Returns whether vertices sample lights at all. */
  boolean samplesLights(List<Light> emitters) {
    return !emitters.isEmpty();
  }
}
