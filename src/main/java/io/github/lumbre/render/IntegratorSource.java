package io.github.lumbre.render;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.render.internal.GuideReport;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Guiding;
import io.github.lumbre.scene.Scene;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/** Makes the integrator of a renderer when the first pass needs it. Shared by threads. */
final class IntegratorSource {
  private final RenderSettings settings;
  private final Scene scene;
  private Optional<Integrator> integrator;
  private volatile Optional<GuideReport> guiding = Optional.empty();

  private IntegratorSource(RenderSettings settings, Scene scene, Optional<Integrator> integrator) {
    this.settings = settings;
    this.scene = scene;
    this.integrator = integrator;
  }

  /** Returns the source of a given integrator. */
  static IntegratorSource of(RenderSettings settings, Scene scene, Integrator integrator) {
    return new IntegratorSource(settings, scene, Optional.of(integrator));
  }

  /** Returns the source of the integrator that the settings select. */
  static IntegratorSource of(RenderSettings settings, Scene scene) {
    return settings.guiding() == Guiding.OFF
        ? of(settings, scene, Integrator.of(scene, settings))
        : new IntegratorSource(settings, scene, Optional.empty());
  }

  /**
   * Returns the integrator, the same at each call.
   *
   * @param crew renders the pilot if there is none yet
   * @throws InterruptedException if the calling thread is interrupted; no thread then works on it
   * @throws CancellationException if the crew was stopped
   */
  synchronized Integrator get(PilotRows crew) throws InterruptedException {
    if (integrator.isEmpty()) {
      GuidePilot.Learned learned = GuidePilot.learn(settings, scene, crew);
      guiding = Optional.of(learned.report());
      integrator = Optional.of(Integrator.of(scene, settings, learned.guide()));
    }
    return integrator.get();
  }

  /** Returns the report on the pilot render; empty if there is none, or none yet. */
  Optional<GuideReport> guiding() {
    return guiding;
  }
}
