package io.github.lumbre.integrator;

import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSampler;
import io.github.lumbre.scene.Scene;

/** How a vertex selects the emitter that it samples. All kinds have the same mean. */
public enum LightSamplerKind {
  /** By what may come from each to the vertex: see {@link LightSampler#over}. */
  PLACE {
    @Override
    LightSampler over(Scene scene) {
      return LightSampler.over(scene.emitters());
    }
  },
  /** By power, at all vertices alike: see {@link LightSampler#byPower}. */
  POWER {
    @Override
    LightSampler over(Scene scene) {
      double[] powers = scene.emitters().stream().mapToDouble(e -> power(e, scene)).toArray();
      return LightSampler.byPower(powers.length == 0 ? new double[1] : powers);
    }
  },
  /** Each as often as any other. */
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
