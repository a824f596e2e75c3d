package io.github.lumbre.render;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Optional;

/** Makes the integrator of a renderer when the first pass needs it. Shared by threads. */
interface IntegratorSource {
  /**
   * Returns the integrator, the same at each call.
   *
   * @param threads the number of threads that may work on it
   * @throws InterruptedException if the calling thread is interrupted; no thread then works on it
   */
  Integrator get(int threads) throws InterruptedException;

  /** Returns the report on the pilot render; empty if there is none, or none yet. */
  default Optional<SplitReport> report() {
    return Optional.empty();
  }

  /** Returns the source of the integrator that the settings select. */
  static IntegratorSource of(RenderSettings settings, Scene scene) {
    if (settings.split() == RenderSettings.AUTO_SPLIT) {
      return new Piloted(settings, scene);
    }
    Integrator integrator = Integrator.of(scene, settings);
    return threads -> integrator;
  }

  /** A source that renders a pilot once. */
  final class Piloted implements IntegratorSource {
    private final RenderSettings settings;
    private final Scene scene;
    private Optional<Integrator> integrator = Optional.empty();
    private volatile Optional<SplitReport> report = Optional.empty();

    private Piloted(RenderSettings settings, Scene scene) {
      this.settings = settings;
      this.scene = scene;
    }

    @Override
    public synchronized Integrator get(int threads) throws InterruptedException {
      if (integrator.isEmpty()) {
        SplitReport chosen = SplitPilot.choose(settings, scene, threads);
        integrator = Optional.of(Integrator.of(scene, chosen.applyTo(settings)));
        report = Optional.of(chosen);
      }
      return integrator.get();
    }

    @Override
    public Optional<SplitReport> report() {
      return report;
    }
  }
}
