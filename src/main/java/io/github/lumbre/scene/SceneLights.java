package io.github.lumbre.scene;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.internal.LightGroups;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** The lights of a scene in its two lists, and where each stands in the list of emitters. */
final class SceneLights {
  private final List<Light> declared;
  private final List<Light> emitters;
  private final List<EnvironmentLight> environments;
  private final LightGroups groups;

  /** The index in {@code emitters} of each environment light, and of each declared light. */
  private final int[] ofEnvironment, ofLight;

  /** The index in {@code emitters} of each primitive; -1 if it is not sampled as a light. */
  private final int[] ofPrimitive;

  SceneLights(SceneAssembly built) {
    declared = List.copyOf(built.lights);
    emitters = List.copyOf(built.emitters);
    environments =
        emitters.stream()
            .filter(EnvironmentLight.class::isInstance)
            .map(EnvironmentLight.class::cast)
            .toList();
    groups = new LightGroups(built.groupOfEmitter, built.groupOfPrimitive, built.primitives);
    ofEnvironment = indices(environments);
    ofLight = indices(declared);
    ofPrimitive = new int[built.primitives.size()];
    Arrays.setAll(ofPrimitive, i -> built.emitterOfPrimitive.getOrDefault(i, -1));
  }

  /** Returns the index in {@code emitters} of each light, or -1; both have the same order. */
  private int[] indices(List<? extends Light> some) {
    int[] indices = new int[some.size()];
    int next = 0;
    for (int i = 0; i < indices.length; i++) {
      indices[i] = indexOf(some.get(i), next);
      next = Math.max(next, indices[i] + 1);
    }
    return indices;
  }

  private int indexOf(Light light, int from) {
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

  List<Light> declared() {
    return declared;
  }

  List<Light> emitters() {
    return emitters;
  }

  List<EnvironmentLight> environments() {
    return environments;
  }

  Rgb background(Vec3 direction) {
    Rgb sum = Rgb.BLACK;
    for (EnvironmentLight environment : environments) {
      sum = sum.plus(environment.from(direction));
    }
    return sum;
  }

  LightGroups groups() {
    return groups;
  }

  int ofPrimitive(int primitive) {
    return ofPrimitive[primitive];
  }

  int ofEnvironment(int environment) {
    return ofEnvironment[environment];
  }

  int ofLight(int light) {
    return ofLight[light];
  }
}
