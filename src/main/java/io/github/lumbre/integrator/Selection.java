package io.github.lumbre.integrator;

import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSelector;
import io.github.lumbre.scene.Scene;

/** How a vertex chooses the one emitter that it asks for light. All choices have the same mean. */
public enum Selection {
  /** By what may come from each to the vertex: see {@link LightSelector#over}. */
  PLACE {
    @Override
    LightSelector over(Scene scene) {
      return LightSelector.over(scene.emitters());
    }
  },
  /** By power, at all vertices alike: see {@link LightSelector#byPower}. */
  POWER {
    @Override
    LightSelector over(Scene scene) {
      double[] powers = scene.emitters().stream().mapToDouble(e -> power(e, scene)).toArray();
      return LightSelector.byPower(powers.length == 0 ? new double[1] : powers);
    }
  },
  /** Each as often as any other. */
  UNIFORM {
    @Override
    LightSelector over(Scene scene) {
      return LightSelector.byPower(new double[Math.max(1, scene.emitters().size())]);
    }
  };

  abstract LightSelector over(Scene scene);

  private static double power(Light emitter, Scene scene) {
    return emitter.power(scene.radius());
  }
}
