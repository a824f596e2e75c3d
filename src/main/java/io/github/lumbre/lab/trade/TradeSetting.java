package io.github.lumbre.lab.trade;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.PathOptions;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.integrator.RayTracer;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.function.Function;
import java.util.function.LongFunction;

/**
 * A way to render a scene that a study measures at several numbers of samples.
 *
 * @param knob what is turned: {@code depth}, {@code mode}, ...
 * @param value of the knob, as on the command line if it is there
 * @param kind what the knob changes beside the time
 * @param flags that choose the setting on the command line; empty if none do
 * @param scene as read for the settings' mode
 * @param method makes the integrator of a scene
 * @param samplers makes the random numbers of a seed
 */
public record TradeSetting(
    String knob,
    String value,
    Kind kind,
    String flags,
    TradeScene scene,
    RenderSettings settings,
    Function<Scene, Integrator> method,
    LongFunction<Sampler> samplers) {

  /** What a knob changes beside the time; settings of different kinds are not ranked together. */
  public enum Kind {
    /** The noise: the mean of all such pictures is the truth. */
    NOISE,
    /** What the pictures converge to, so that no number of samples brings the truth. */
    BIAS
  }

  /** Returns a setting of path tracing with Sobol points. */
  static TradeSetting ofPaths(
      String knob,
      String value,
      Kind kind,
      String flags,
      TradeScene scene,
      RenderSettings settings,
      PathOptions options) {
    return new TradeSetting(
        knob,
        value,
        kind,
        flags,
        scene,
        settings,
        s -> new PathTracer(s, options),
        SobolSampler::new);
  }

  /** Returns the setting of ray tracing with the depths of its settings. */
  static TradeSetting ofRays(TradeScene scene, RenderSettings settings) {
    return new TradeSetting(
        "mode",
        "ray",
        Kind.BIAS,
        "--mode ray",
        scene,
        settings,
        s -> new RayTracer(s, settings.reflectionTraceDepth(), settings.refractionTraceDepth()),
        SobolSampler::new);
  }

  /** Tells whether samples alone stand between picture and reference. */
  public boolean isUnbiased() {
    return kind == Kind.NOISE;
  }

  /** Returns the setting's name in the terms of the field. */
  public String label() {
    return TradeText.label(knob, value);
  }

  /** Returns what renders the setting with a seed. */
  FilmRenderer renderer(long seed) {
    return renderer(scene.scene(), settings.toBuilder().seed(seed).build());
  }

  /** Returns what renders the setting in another scene, and a frame of other settings. */
  FilmRenderer renderer(Scene other, RenderSettings frame) {
    return new FilmRenderer(frame, other, method.apply(other), samplers);
  }
}
