package io.github.lumbre.integrator;

import io.github.lumbre.light.Light;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.scene.Scene;

/**
 * The light sampler that a path tracer uses. All kinds give the same mean and differ in variance.
 */
public enum LightSamplerKind {
  /**
   * Selects by an estimate of each light's contribution at the vertex: see {@link
   * LightSampler#over}.
   */
  PLACE {
    @Override
    LightSampler over(Scene scene) {
      return LightSampler.over(scene.emitters());
    }
  },
  /**
   * Selects by power, with the same probabilities at all vertices: see {@link
   * LightSampler#byPower}.
   */
  POWER {
    @Override
    LightSampler over(Scene scene) {
      double[] powers = scene.emitters().stream().mapToDouble(e -> power(e, scene)).toArray();
      return LightSampler.byPower(powers.length == 0 ? new double[1] : powers);
    }
  },
  /** Selects all lights with the same probability. */
  UNIFORM {
    @Override
    LightSampler over(Scene scene) {
      return LightSampler.byPower(new double[Math.max(1, scene.emitters().size())]);
    }
  };

  abstract LightSampler over(Scene scene);

  private static double power(Light emitter, Scene scene) {
    return emitter.power(scene.radius());
  }
}
