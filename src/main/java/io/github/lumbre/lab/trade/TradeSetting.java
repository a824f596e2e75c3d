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
 * A setting that a study measures at several numbers of samples.
 *
 * @param knob varied parameter: {@code depth}, {@code mode}, ...
 * @param value value of the parameter, as on the command line if it has a flag
 * @param kind whether the setting changes the noise or the bias
 * @param flags command line flags of the setting; empty if there are none
 * @param scene scene, read for the mode of the settings
 * @param method creates the integrator of a scene
 * @param samplers creates the sampler of a seed
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

  /**
   * The effect of a setting besides the time; settings of different kinds are not ranked together.
   */
  public enum Kind {
    /** The setting is unbiased and changes only the noise. */
    NOISE,
    /** The setting is biased: its pictures converge to a different limit. */
    BIAS
  }

  /** Returns a setting for path tracing with Sobol points. */
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

  /** Returns the setting for ray mode with the depths of its settings. */
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

  /** Returns whether the setting is unbiased. */
  public boolean isUnbiased() {
    return kind == Kind.NOISE;
  }

  /** Returns the setting's display name. */
  public String label() {
    return TradeText.label(knob, value);
  }

  /** Returns a renderer of the setting with a seed. */
  FilmRenderer renderer(long seed) {
    return renderer(scene.scene(), settings.toBuilder().seed(seed).build());
  }

  /** Returns a renderer of the setting for another scene and other frame settings. */
  FilmRenderer renderer(Scene other, RenderSettings frame) {
    return new FilmRenderer(frame, other, method.apply(other), samplers);
  }
}
