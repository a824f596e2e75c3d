package io.github.lumbre.parser;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Reads {@code renderOptions}. */
final class SettingsReader {
  private static final RenderSettings DEFAULT = RenderSettings.DEFAULT;
  private static final int DEFAULT_ANTIALIASING = 2;
  private static final Map<String, Mode> MODES = ordered("ray", Mode.RAY, "path", Mode.PATH);
  private static final Map<String, ToneCurve> TONE_CURVES =
      ordered(
          "srgb", ToneCurve.SRGB,
          "gamma22", ToneCurve.GAMMA22,
          "reinhard", ToneCurve.REINHARD,
          "aces", ToneCurve.ACES);
  private static final String TRANSPARENT = "transparent";
  static final Set<String> KEYS =
      Set.of(
          "width",
          "height",
          "antialiasing",
          "threads",
          "bucketSize",
          "reflectionTraceDepth",
          "refractionTraceDepth",
          "maxTraceDepth",
          "mode",
          "samples",
          "seed",
          "exposure",
          "toneMap",
          "background",
          "name");

  private SettingsReader() {}

  @SuppressWarnings("unchecked")
  private static <T> Map<String, T> ordered(Object... namesAndValues) {
    Map<String, T> map = new LinkedHashMap<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      map.put((String) namesAndValues[i], (T) namesAndValues[i + 1]);
    }
    return map;
  }

  /**
   * Returns the settings that a scene asks for; in place of wrong values, the defaults.
   *
   * @param mode to use whatever the scene says
   */
  static RenderSettings read(JsonNode options, Optional<Mode> mode) {
    options.warnUnknown(KEYS);
    Mode inFile = options.choice("mode", MODES, DEFAULT.mode());
    Mode used = mode.orElse(inFile);
    int forRays = raySamples(options);
    int forPaths = options.integer("samples", DEFAULT.samples(), 1, RenderSettings.MAX_SAMPLES);
    return new RenderSettings.Builder()
        .mode(used)
        .samples(used == Mode.RAY ? forRays : forPaths)
        .size(side(options, "width", DEFAULT.width()), side(options, "height", DEFAULT.height()))
        .maxTraceDepth(depth(options, "maxTraceDepth", DEFAULT.maxTraceDepth()))
        .rayDepths(
            depth(options, "reflectionTraceDepth", DEFAULT.reflectionTraceDepth()),
            depth(options, "refractionTraceDepth", DEFAULT.refractionTraceDepth()))
        .threads(options.integer("threads", DEFAULT.threads(), 0, RenderSettings.MAX_THREADS))
        .bucketSize(options.integer("bucketSize", DEFAULT.bucketSize(), 1, Integer.MAX_VALUE))
        .seed(options.integer("seed", DEFAULT.seed(), Long.MIN_VALUE, Long.MAX_VALUE))
        .exposure(exposure(options))
        .toneCurve(options.choice("toneMap", TONE_CURVES, DEFAULT.toneCurve()))
        .transparent(isTransparent(options))
        .build();
  }

  /** Returns the settings of a scene that asks for nothing. */
  static RenderSettings missing(Optional<Mode> mode) {
    Mode used = mode.orElse(DEFAULT.mode());
    int samples = used == Mode.RAY ? raySamples(DEFAULT_ANTIALIASING) : DEFAULT.samples();
    return DEFAULT.toBuilder().mode(used).samples(samples).build();
  }

  private static int side(JsonNode options, String key, int missing) {
    return options.integer(key, missing, 1, RenderSettings.MAX_SIDE);
  }

  private static int depth(JsonNode options, String key, int missing) {
    return options.integer(key, missing, 0, RenderSettings.MAX_DEPTH);
  }

  /** The format counts in powers of two, and only every other one exists: 1, 4, 16, … */
  private static int raySamples(int exponent) {
    return 1 << exponent + exponent % 2;
  }

  private static int raySamples(JsonNode options) {
    int n = options.integer("antialiasing", DEFAULT_ANTIALIASING, -1, 16);
    return raySamples(n == -1 ? DEFAULT_ANTIALIASING : n);
  }

  private static Exposure exposure(JsonNode options) {
    Optional<JsonNode> node = options.find("exposure");
    if (node.isEmpty()) {
      return DEFAULT.exposure();
    }
    if (node.get().isText("auto")) {
      return Exposure.AUTO;
    }
    if (!node.get().isNumber()) {
      node.get().error("expected a finite number or \"auto\", found " + node.get().found());
      return DEFAULT.exposure();
    }
    return Exposure.of(options.number("exposure", 0, Range.ANY));
  }

  private static boolean isTransparent(JsonNode options) {
    return options.find("background").filter(n -> n.isText(TRANSPARENT)).isPresent();
  }

  /** Returns the radiance of the background, or empty if the scene names none. */
  static Optional<Rgb> background(JsonNode options) {
    Optional<JsonNode> node = options.find("background");
    if (node.isEmpty() || isTransparent(options)) {
      return Optional.empty();
    }
    if (!node.get().isObject()) {
      node.get()
          .error("expected {r, g, b} or \"" + TRANSPARENT + "\", found " + node.get().found());
      return Optional.empty();
    }
    return Optional.of(node.get().rgb());
  }
}
