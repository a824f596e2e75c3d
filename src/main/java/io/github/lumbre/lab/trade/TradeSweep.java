package io.github.lumbre.lab.trade;

import io.github.lumbre.integrator.LightSamplerKind;
import io.github.lumbre.integrator.MisHeuristic;
import io.github.lumbre.integrator.PathOptions;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.lab.trade.TradeSetting.Kind;
import io.github.lumbre.sampling.IndependentSampler;
import io.github.lumbre.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** The settings that a study compares: each differs from the baseline in one parameter. */
public final class TradeSweep {
  /** The names of all parameters, in the order of the page. */
  public static final List<String> KNOBS =
      List.of(
          "sampler",
          "lights",
          "strategy",
          "roulette",
          "split",
          "depth",
          "mode",
          "filter",
          "clamp",
          "adaptive",
          "denoise");

  private static final String ADAPTIVE = "adaptive";

  /** Twice the samples per pixel after which adaptive sampling starts. */
  private static final int ADAPTIVE_SAMPLES = 64;

  private static final int[] DEPTHS = {1, 2, 3, 5, 8, 16};
  private static final int[] ROULETTE = {2, 4, 8, 32};
  private static final int[] SPLITS = {2, 4, 8};
  private static final int[] CLAMPS = {1, 10, 100};

  /** A depth that Russian roulette hardly ever lets a path reach. */
  private static final int DEEP = 1000;

  private static final PathOptions USUAL = PathOptions.toDepth(DEEP);

  private final TradeScene scene;
  private final RenderSettings settings;
  private final Set<String> knobs;
  private final List<TradeSetting> all = new ArrayList<>();

  /**
   * @param scene scene, read for path tracing
   * @param settings settings for path tracing; their depth is ignored
   * @param knobs names of the parameters to vary
   */
  public TradeSweep(TradeScene scene, RenderSettings settings, Set<String> knobs) {
    this.scene = scene;
    this.settings = usual(settings);
    this.knobs = Set.copyOf(knobs);
    all.add(paths("depth", DEEP, Kind.NOISE, "--depth " + DEEP, USUAL));
    addWaysToTheSameLight();
    if (knobs.contains("depth")) {
      for (int depth : DEPTHS) {
        String flags = "--depth " + depth;
        all.add(paths("depth", depth, Kind.BIAS, flags, PathOptions.toDepth(depth)));
      }
    }
    if (knobs.contains("clamp")) {
      addClamps();
    }
    if (knobs.contains(ADAPTIVE)) {
      addAdaptive();
    }
    if (knobs.contains("denoise")) {
      all.add(TradeSetting.ofDenoised(scene, this.settings, "--depth " + DEEP, USUAL));
    }
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

  private void addClamps() {
    for (int clamp : CLAMPS) {
      all.add(
          TradeSetting.ofPaths(
              "clamp",
              String.valueOf(clamp),
              Kind.BIAS,
              "--clamp " + clamp + " --depth " + DEEP,
              scene,
              settings.toBuilder().clamp(clamp).build(),
              USUAL));
    }
  }

  private void addAdaptive() {
    all.add(
        TradeSetting.ofPaths(
            ADAPTIVE,
            "on",
            Kind.BIAS,
            "--adaptive --depth " + DEEP,
            scene,
            settings.toBuilder().adaptive(true).build(),
            USUAL));
  }

  private void addWaysToTheSameLight() {
    if (knobs.contains("sampler")) {
      all.add(
          new TradeSetting(
              "sampler",
              "independent",
              Kind.NOISE,
              "",
              scene,
              settings,
              s -> new PathTracer(s, USUAL.transparent(settings.transparent())),
              IndependentSampler::new));
    }
    if (knobs.contains("lights") && scene.scene().emitters().size() > 1) {
      addNoise("lights", LightSamplerKind.POWER, USUAL.by(LightSamplerKind.POWER));
      addNoise("lights", LightSamplerKind.UNIFORM, USUAL.by(LightSamplerKind.UNIFORM));
    }
    if (knobs.contains("strategy")) {
      addNoise("strategy", MisHeuristic.BALANCE, USUAL.by(MisHeuristic.BALANCE));
      addNoise("strategy", MisHeuristic.LIGHT, USUAL.by(MisHeuristic.LIGHT));
      addNoise("strategy", MisHeuristic.BSDF, USUAL.by(MisHeuristic.BSDF));
    }
    if (knobs.contains("roulette")) {
      for (int vertex : ROULETTE) {
        addNoise("roulette", "from " + vertex, USUAL.rouletteFrom(vertex));
      }
    }
    if (knobs.contains("split")) {
      for (int ways : SPLITS) {
        String flags = "--split " + ways + " --depth " + DEEP;
        all.add(paths("split", ways, Kind.NOISE, flags, USUAL.splitInto(ways)));
      }
    }
  }

  private void addNoise(String knob, Object value, PathOptions options) {
    all.add(paths(knob, value, Kind.NOISE, "", options));
  }

  private TradeSetting paths(
      String knob, Object value, Kind kind, String flags, PathOptions options) {
    String name = value.toString().toLowerCase(Locale.ROOT);
    return TradeSetting.ofPaths(knob, name, kind, flags, scene, settings, options);
  }

  /** Adds ray mode, with the scene read for it, if modes are compared. */
  public void addRays(TradeScene read, RenderSettings ofRays) {
    if (knobs.contains("mode")) {
      all.add(TradeSetting.ofRays(read, ofRays));
    }
  }

  /** Adds the scene read with another texture filter, if filters are compared. */
  public void addFilter(String name, TradeScene read) {
    if (knobs.contains("filter")) {
      all.add(TradeSetting.ofPaths("filter", name, Kind.BIAS, "", read, settings, USUAL));
    }
  }

  /**
   * Returns all settings, the baseline first.
   *
   * @param mostSamples largest number of samples per pixel; with few samples adaptive sampling has
   *     no effect and is skipped, with a single one there is nothing to denoise by
   */
  public List<TradeSetting> settings(int mostSamples) {
    return all.stream()
        .filter(setting -> mostSamples >= ADAPTIVE_SAMPLES || !setting.knob().equals(ADAPTIVE))
        .filter(setting -> mostSamples >= setting.leastSamples())
        .toList();
  }
}
