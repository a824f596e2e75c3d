package io.github.lumbre.lab.trade;

import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.LightSamplerKind;
import io.github.lumbre.integrator.MisHeuristic;
import io.github.lumbre.integrator.PathOptions;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.IndependentSampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Function;
import java.util.function.LongFunction;

/** The settings that a study compares: each differs from the baseline in one parameter. */
public final class TradeSweep {
  /** Twice the samples per pixel after which adaptive sampling starts. */
  private static final int ADAPTIVE_SAMPLES = 64;

  /** A depth that Russian roulette hardly ever lets a path reach. */
  private static final int DEEP = 1000;

  private static final String DEEP_FLAG = "--depth " + DEEP;
  private static final PathOptions USUAL = PathOptions.toDepth(DEEP);

  private final TradeScene scene;
  private final RenderSettings usual;
  private final Set<Knob> knobs;
  private final List<TradeSetting> all = new ArrayList<>();

  /**
   * @param scene scene, read for path tracing
   * @param settings settings for path tracing; their depth is ignored
   * @param knobs parameters to vary
   */
  public TradeSweep(TradeScene scene, RenderSettings settings, Set<Knob> knobs) {
    this.scene = scene;
    this.usual = usual(settings);
    this.knobs = Set.copyOf(knobs);
    all.add(setting(Knob.DEPTH, DEEP, Kind.NOISE, DEEP_FLAG, usual, USUAL));
    addUnbiased();
    for (int depth : new int[] {1, 2, 3, 5, 8, 16}) {
      String flag = "--depth " + depth;
      add(setting(Knob.DEPTH, depth, Kind.BIAS, flag, usual, PathOptions.toDepth(depth)));
    }
    for (int clamp : new int[] {1, 10, 100}) {
      String flags = "--clamp " + clamp + " " + DEEP_FLAG;
      RenderSettings clamped = usual.toBuilder().clamp(clamp).build();
      add(setting(Knob.CLAMP, clamp, Kind.BIAS, flags, clamped, USUAL));
    }
    RenderSettings adaptive = usual.toBuilder().adaptive(true).build();
    add(setting(Knob.ADAPTIVE, "on", Kind.BIAS, "--adaptive " + DEEP_FLAG, adaptive, USUAL));
    RenderSettings layered = usual.toBuilder().set(Setting.LAYERS, Layer.FOR_DENOISING).build();
    String denoise = "--denoise " + DEEP_FLAG;
    add(setting(Knob.DENOISE, "builtin", Kind.DENOISED, denoise, layered, USUAL));
  }

  /** Returns the baseline's settings for path tracing. */
  public static RenderSettings usual(RenderSettings settings) {
    return settings.toBuilder()
        .maxTraceDepth(DEEP)
        .adaptive(false)
        .split(1)
        .clamp(Double.POSITIVE_INFINITY)
        .build();
  }

  private void addUnbiased() {
    LongFunction<Sampler> independent = IndependentSampler::new;
    add(
        new TradeSetting(
            Knob.SAMPLER, "independent", Kind.NOISE, "", scene, usual, paths(USUAL), independent));
    if (scene.scene().emitters().size() > 1) {
      for (LightSamplerKind kind : List.of(LightSamplerKind.POWER, LightSamplerKind.UNIFORM)) {
        add(setting(Knob.LIGHTS, kind, Kind.NOISE, "", usual, USUAL.by(kind)));
      }
    }
    for (MisHeuristic heuristic :
        List.of(MisHeuristic.BALANCE, MisHeuristic.LIGHT, MisHeuristic.BSDF)) {
      add(setting(Knob.STRATEGY, heuristic, Kind.NOISE, "", usual, USUAL.by(heuristic)));
    }
    for (int vertex : new int[] {2, 4, 8, 32}) {
      PathOptions options = USUAL.rouletteFrom(vertex);
      add(setting(Knob.ROULETTE, "from " + vertex, Kind.NOISE, "", usual, options));
    }
    for (int ways : new int[] {2, 4, 8}) {
      String flags = "--split " + ways + " " + DEEP_FLAG;
      add(setting(Knob.SPLIT, ways, Kind.NOISE, flags, usual, USUAL.splitInto(ways)));
    }
  }

  /** Adds a setting if its parameter is to be varied. */
  private void add(TradeSetting setting) {
    if (knobs.contains(setting.knob())) {
      all.add(setting);
    }
  }

  private TradeSetting setting(
      Knob knob,
      Object value,
      Kind kind,
      String flags,
      RenderSettings settings,
      PathOptions options) {
    String name = value.toString().toLowerCase(Locale.ROOT);
    return new TradeSetting(
        knob, name, kind, flags, scene, settings, paths(options), SobolSampler::new);
  }

  private Function<Scene, Integrator> paths(PathOptions options) {
    return s -> new PathTracer(s, options.transparent(usual.transparent()));
  }

  /** Adds ray mode with the depths of its settings, if modes are compared. */
  public void addRays(TradeScene read, RenderSettings ofRays) {
    RenderSettings rays = ofRays.toBuilder().mode(RenderSettings.Mode.RAY).build();
    Function<Scene, Integrator> method = s -> Integrator.of(s, rays);
    add(
        new TradeSetting(
            Knob.MODE, "ray", Kind.BIAS, "--mode ray", read, ofRays, method, SobolSampler::new));
  }

  /** Adds the scene read with another texture filter, if filters are compared. */
  public void addFilter(String name, TradeScene read) {
    add(
        new TradeSetting(
            Knob.FILTER, name, Kind.BIAS, "", read, usual, paths(USUAL), SobolSampler::new));
  }

  /**
   * Returns all settings, the baseline first.
   *
   * @param mostSamples largest number of samples per pixel; with few samples adaptive sampling has
   *     no effect and is skipped, with a single one there is nothing to denoise by
   */
  public List<TradeSetting> settings(int mostSamples) {
    return all.stream()
        .filter(setting -> mostSamples >= ADAPTIVE_SAMPLES || setting.knob() != Knob.ADAPTIVE)
        .filter(setting -> mostSamples >= setting.leastSamples())
        .toList();
  }
}
