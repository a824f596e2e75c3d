package io.github.lumbre.render;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Guiding;
import io.github.lumbre.scene.Scene;
import java.util.Objects;
import java.util.Optional;

/** Makes the integrator of a renderer when the first pass needs it. Shared by threads. */
interface IntegratorSource {
  /**
   * Returns the integrator, the same at each call.
   *
   * @param crew renders the pilot if there is none yet
   * @throws InterruptedException if the calling thread is interrupted; no thread then works on it
   * @throws PilotRows.Stopped if the crew was stopped
   */
  Integrator get(PilotRows crew) throws InterruptedException, PilotRows.Stopped;

  /** Returns the report on the pilot render; empty if there is none, or none yet. */
  default Optional<GuideReport> guiding() {
    return Optional.empty();
  }

  /** Returns the source of a given integrator. */
  static IntegratorSource of(Integrator integrator) {
    Objects.requireNonNull(integrator, "integrator");
    return crew -> integrator;
  }

  /** Returns the source of the integrator that the settings select. */
  static IntegratorSource of(RenderSettings settings, Scene scene) {
    return settings.guiding() == Guiding.OFF
        ? of(Integrator.of(scene, settings))
        : new Guided(settings, scene);
  }

  /** A source that renders the pilot once. */
  final class Guided implements IntegratorSource {
    private final RenderSettings settings;
    private final Scene scene;
    private Optional<Integrator> integrator = Optional.empty();
    private volatile Optional<GuideReport> guiding = Optional.empty();

    private Guided(RenderSettings settings, Scene scene) {
      this.settings = settings;
      this.scene = scene;
    }

    @Override
    public synchronized Integrator get(PilotRows crew)
        throws InterruptedException, PilotRows.Stopped {
      if (integrator.isEmpty()) {
        GuidePilot.Learned learned = GuidePilot.learn(settings, scene, crew);
        guiding = Optional.of(learned.report());
        integrator = Optional.of(Integrator.of(scene, settings, learned.guide()));
      }
      return integrator.get();
    }

    @Override
    public Optional<GuideReport> guiding() {
      return guiding;
    }
  }
}
