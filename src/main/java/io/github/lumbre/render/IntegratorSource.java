package io.github.lumbre.render;

import io.github.lumbre.guiding.Guide;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Guiding;
import io.github.lumbre.scene.Scene;
import java.util.Objects;
import java.util.Optional;

/** Makes the integrator of a renderer when the first pass needs it. Shared by threads. */
interface IntegratorSource {
  /**
   * An integrator and its plan.
   *
   * @param plan the number of branches of each pixel, for an integrator that follows it
   */
  record Planned(Integrator integrator, SplitPlan plan) {}

  /**
   * Returns the integrator, the same at each call.
   *
   * @param crew renders the pilot if there is none yet
   * @throws InterruptedException if the calling thread is interrupted; no thread then works on it
   * @throws PilotRows.Stopped if the crew was stopped
   */
  Planned get(PilotRows crew) throws InterruptedException, PilotRows.Stopped;

  /** Returns the report on the pilot render of splitting; empty if there is none, or none yet. */
  default Optional<SplitReport> report() {
    return Optional.empty();
  }

  /** Returns the report on the pilot render of guiding; empty if there is none, or none yet. */
  default Optional<GuideReport> guiding() {
    return Optional.empty();
  }

  /** Returns the source of a given integrator. */
  static IntegratorSource of(Integrator integrator) {
    Objects.requireNonNull(integrator, "integrator");
    Planned planned = new Planned(integrator, SplitPlan.NONE);
    return crew -> planned;
  }

  /** Returns the source of the integrator that the settings select. */
  static IntegratorSource of(RenderSettings settings, Scene scene) {
    return settings.split() == RenderSettings.AUTO_SPLIT || settings.guiding() != Guiding.OFF
        ? new Piloted(settings, scene)
        : of(Integrator.of(scene, settings));
  }

  /** A source that renders each pilot once. */
  final class Piloted implements IntegratorSource {
    private final RenderSettings settings;
    private final Scene scene;
    private Optional<Planned> planned = Optional.empty();
    private volatile Optional<SplitReport> report = Optional.empty();
    private volatile Optional<GuideReport> guiding = Optional.empty();

    private Piloted(RenderSettings settings, Scene scene) {
      this.settings = settings;
      this.scene = scene;
    }

    @Override
    public synchronized Planned get(PilotRows crew) throws InterruptedException, PilotRows.Stopped {
      if (planned.isEmpty()) {
        Guide guide = guide(crew);
        RenderSettings chosen = settings;
        SplitPlan plan = SplitPlan.NONE;
        if (settings.split() == RenderSettings.AUTO_SPLIT) {
          SplitReport split = SplitPilot.choose(settings, scene, crew);
          chosen = split.applyTo(settings);
          plan = split.plan();
          report = Optional.of(split);
        }
        planned = Optional.of(new Planned(Integrator.of(scene, chosen, guide), plan));
      }
      return planned.get();
    }

    private Guide guide(PilotRows crew) throws InterruptedException, PilotRows.Stopped {
      if (settings.guiding() == Guiding.OFF) {
        return Guide.NONE;
      }
      GuidePilot.Learned learned = GuidePilot.learn(settings, scene, crew);
      guiding = Optional.of(learned.report());
      return learned.guide();
    }

    @Override
    public Optional<GuideReport> guiding() {
      return guiding;
    }

    @Override
    public Optional<SplitReport> report() {
      return report;
    }
  }
}
