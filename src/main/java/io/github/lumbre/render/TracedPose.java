package io.github.lumbre.render;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * A pose of a scene, and its integrator. Number i of a pixel's samples sees pose i modulo the
 * number of poses.
 */
record TracedPose(Scene scene, Integrator integrator) {
  /** Returns the poses of a scene with the integrator that the settings select. */
  static List<TracedPose> of(Scene scene, RenderSettings settings, Guide guide) {
    return of(scene, pose -> Integrator.of(pose, settings, guide));
  }

  /** Returns the poses of a scene; one that stands for several gets one integrator. */
  static List<TracedPose> of(Scene scene, Function<Scene, Integrator> integrators) {
    Map<Scene, TracedPose> known = new IdentityHashMap<>();
    return scene.poses().stream()
        .map(pose -> known.computeIfAbsent(pose, p -> new TracedPose(p, integrators.apply(p))))
        .toList();
  }
}
