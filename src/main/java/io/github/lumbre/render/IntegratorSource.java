package io.github.lumbre.render;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.render.internal.GuideReport;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Guiding;
import io.github.lumbre.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Function;

/** Makes the integrators of a renderer when the first pass needs them. Shared by threads. */
final class IntegratorSource {
  private final RenderSettings settings;
  private final Scene scene;
  private Optional<List<TracedPose>> poses;
  private volatile Optional<GuideReport> guiding = Optional.empty();

  private IntegratorSource(RenderSettings settings, Scene scene, Optional<List<TracedPose>> poses) {
    this.settings = settings;
    this.scene = scene;
    this.poses = poses;
  }

  /** Returns the source of given integrators. */
  static IntegratorSource of(
      RenderSettings settings, Scene scene, Function<Scene, Integrator> integrators) {
    return new IntegratorSource(settings, scene, Optional.of(TracedPose.of(scene, integrators)));
  }

  /** Returns the source of the integrator that the settings select. */
  static IntegratorSource of(RenderSettings settings, Scene scene) {
    return settings.guiding() == Guiding.OFF
        ? of(settings, scene, pose -> Integrator.of(pose, settings))
        : new IntegratorSource(settings, scene, Optional.empty());
  }

  /**
   * Returns the poses of the scene with their integrators, the same at each call.
   *
   * @param crew renders the pilot if there is none yet
   * @throws InterruptedException if the calling thread is interrupted; no thread then works on it
   * @throws CancellationException if the crew was stopped
   */
  synchronized List<TracedPose> get(PilotRows crew) throws InterruptedException {
    if (poses.isEmpty()) {
      GuidePilot.Learned learned = GuidePilot.learn(settings, scene, crew);
      guiding = Optional.of(learned.report());
      poses = Optional.of(TracedPose.of(scene, settings, learned.guide()));
    }
    return poses.get();
  }

  /** Returns the report on the pilot render; empty if there is none, or none yet. */
  Optional<GuideReport> guiding() {
    return guiding;
  }
}
