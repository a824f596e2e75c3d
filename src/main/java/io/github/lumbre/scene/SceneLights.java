package io.github.lumbre.scene;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.internal.LightGroups;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * The lights of a scene in its two lists, and where each stands in the list of emitters.
 *
 * @param environments the emitters that are environment lights
 * @param indexOfEnvironment the index in {@code emitters} of each environment light
 * @param indexOfLight the index in {@code emitters} of each declared light
 * @param indexOfPrimitive the index in {@code emitters} of each primitive; -1 if it is not sampled
 *     as a light
 */
record SceneLights(
    List<Light> declared,
    List<Light> emitters,
    List<EnvironmentLight> environments,
    LightGroups groups,
    int[] indexOfEnvironment,
    int[] indexOfLight,
    int[] indexOfPrimitive) {
  static SceneLights of(SceneAssembly built) {
    List<Light> declared = List.copyOf(built.lights);
    List<Light> emitters = List.copyOf(built.emitters);
    List<EnvironmentLight> environments =
        emitters.stream()
            .filter(EnvironmentLight.class::isInstance)
            .map(EnvironmentLight.class::cast)
            .toList();
    int[] ofPrimitive = new int[built.primitives.size()];
    Arrays.setAll(ofPrimitive, i -> built.emitterOfPrimitive.getOrDefault(i, -1));
    return new SceneLights(
        declared,
        emitters,
        environments,
        new LightGroups(built.groupOfEmitter, built.groupOfPrimitive, built.primitives),
        indices(environments, emitters),
        indices(declared, emitters),
        ofPrimitive);
  }

  /** Returns the index in {@code emitters} of each light, or -1; both have the same order. */
  private static int[] indices(List<? extends Light> some, List<Light> emitters) {
    int[] indices = new int[some.size()];
    int next = 0;
    for (int i = 0; i < indices.length; i++) {
      indices[i] = indexOf(some.get(i), next, emitters);
      next = Math.max(next, indices[i] + 1);
    }
    return indices;
  }

  private static int indexOf(Light light, int from, List<Light> emitters) {
    for (int i = from; i < emitters.size(); i++) {
      // Most are the same; comparing others is slow.
      if (emitters.get(i) == light || emitters.get(i).equals(light)) {
        return i;
      }
    }
    return -1;
  }

  /** Returns all lights that any integrator samples; some of them twice. */
  List<Light> all() {
    return Stream.concat(declared.stream(), emitters.stream()).toList();
  }

  Rgb background(Vec3 direction) {
    Rgb sum = Rgb.BLACK;
    for (EnvironmentLight environment : environments) {
      sum = sum.plus(environment.from(direction));
    }
    return sum;
  }

  int ofPrimitive(int primitive) {
    return indexOfPrimitive[primitive];
  }

  int ofEnvironment(int environment) {
    return indexOfEnvironment[environment];
  }

  int ofLight(int light) {
    return indexOfLight[light];
  }
}
