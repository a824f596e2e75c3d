package io.github.lumbre.scenefile;

import com.google.gson.JsonPrimitive;
import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.SettingTypes.ChoiceType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.IntegerType;
import io.github.lumbre.scene.internal.SettingTypes.LongType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.scene.internal.SettingTypes.PowerType;
import io.github.lumbre.scene.internal.SettingTypes.ScreenColorType;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Reads {@code renderOptions}. */
final class SettingsReader {
  private static final RenderSettings DEFAULT = RenderSettings.DEFAULT;
  static final String TRANSPARENT = "transparent";
  private static final String WHITE_LIGHT = "{\"r\": 1, \"g\": 1, \"b\": 1}";

  static final Set<String> KEYS =
      Stream.concat(
              SceneKeys.OF_OPTIONS.stream().map(Key::name),
              Setting.all().stream().filter(Setting::isInScenes).map(Setting::name))
          .collect(Collectors.toUnmodifiableSet());

  private SettingsReader() {}

  /**
   * Returns the settings of a scene. The default replaces each wrong value, and an error is added.
   *
   * @param mode render mode that overrides the scene's; empty to keep it
   */
  static RenderSettings read(JsonNode options, Optional<Mode> mode) {
    options.warnUnknown(KEYS);
    RenderSettings.Builder builder = RenderSettings.builder();
    Setting.all().stream()
        .filter(Setting::isInScenes)
        .forEach(setting -> read(setting, options, builder));
    int raySamples = raySamples(options);
    Mode used = mode.orElse(builder.build().mode());
    if (used == Mode.RAY) {
      builder.samples(raySamples);
    }
    return builder.mode(used).transparent(isTransparent(options)).build();
  }

  /** Returns the settings of a scene without {@code renderOptions}. */
  static RenderSettings missing(Optional<Mode> mode) {
    Mode used = mode.orElse(DEFAULT.mode());
    int samples = used == Mode.RAY ? raySamples(SceneKeys.DEFAULT_ANTIALIASING) : DEFAULT.samples();
    return DEFAULT.toBuilder().mode(used).samples(samples).build();
  }

  private static <T> void read(
      Setting<T> setting, JsonNode options, RenderSettings.Builder builder) {
    builder.set(setting, key(setting).in(options));
  }

  /** Returns the key of a setting. */
  static <T> Key<T> key(Setting<T> setting) {
    return Key.of(setting.name(), value(setting.type()), setting.missing(), setting.meaning());
  }

  @SuppressWarnings("unchecked") // The setting's type has the type of the values.
  private static <T> Value<T> value(SettingType<T> type) {
    if (type instanceof IntegerType range) {
      return (Value<T>) Value.integer(range.low(), range.high());
    }
    if (type instanceof PowerType power) {
      return (Value<T>) power(power);
    }
    if (type instanceof LongType) {
      return (Value<T>) Value.LONG;
    }
    if (type instanceof NumberType range) {
      return (Value<T>) Value.number(range.range());
    }
    if (type instanceof FlagType) {
      return (Value<T>) Value.FLAG;
    }
    if (type instanceof ChoiceType<?> choice) {
      return Value.choice((Map<String, T>) choice.choices());
    }
    if (type instanceof ScreenColorType screen) {
      return (Value<T>)
          new Value<Optional<Rgb>>(
              (options, key, missing) -> screenColor(options, key),
              color -> new JsonPrimitive(screen.format(color)),
              "{'anyOf': [{'$ref': '#/$defs/color'}, {'$ref': '#/$defs/screenColor'}]}");
    }
    return (Value<T>)
        new Value<Exposure>(
            SettingsReader::exposure,
            exposure ->
                exposure.equals(Exposure.AUTO)
                    ? new JsonPrimitive(SettingType.AUTO)
                    : new JsonPrimitive(exposure.stops().getAsDouble()),
            "{'anyOf': [{'type': ['number', 'null']}, {'const': 'auto'}]}");
  }

  private static Value<Integer> power(PowerType type) {
    String powers =
        IntStream.rangeClosed(1, type.high())
            .filter(type::accepts)
            .mapToObj(Integer::toString)
            .collect(Collectors.joining(", "));
    return new Value<>(
        (options, key, missing) -> power(key, missing, type, options),
        JsonPrimitive::new,
        "{'enum': [" + powers + ", null]}");
  }

  private static Integer power(String key, int missing, PowerType type, JsonNode options) {
    int value = options.integer(key, missing, 1, type.high());
    if (type.accepts(value)) {
      return value;
    }
    options.error(key, "expected " + type.expected() + ", found " + value);
    return missing;
  }

  /**
   * Returns the number of samples for the format's exponent of two. Odd exponents do not exist: the
   * numbers are 1, 4, 16, …
   */
  private static int raySamples(int exponent) {
    return 1 << exponent + exponent % 2;
  }

  private static int raySamples(JsonNode options) {
    int n = SceneKeys.ANTIALIASING.in(options);
    return raySamples(n == -1 ? SceneKeys.DEFAULT_ANTIALIASING : n);
  }

  private static Exposure exposure(JsonNode options, String key, Exposure missing) {
    Optional<JsonNode> node = options.find(key);
    if (node.isEmpty()) {
      return missing;
    }
    if (node.get().isText("auto")) {
      return Exposure.AUTO;
    }
    if (!node.get().isNumber()) {
      node.get().error("expected a finite number or \"auto\", found " + node.get().found());
      return missing;
    }
    return Exposure.of(options.number(key, 0, Range.ANY));
  }

  /** Returns a color of the screen; empty if there is none, or the light of {@link #backplate}. */
  private static Optional<Rgb> screenColor(JsonNode options, String key) {
    Optional<JsonNode> node = options.find(key).filter(n -> !n.isObject());
    String text = node.flatMap(JsonNode::text).orElse("");
    Optional<Rgb> color = CssColor.of(text);
    if (node.isPresent() && color.isEmpty()) {
      node.get()
          .error(
              "expected light such as %s, or %s, found %s%s"
                  .formatted(
                      WHITE_LIGHT,
                      Setting.BACKPLATE.type().expected(),
                      node.get().found(),
                      Spelling.suggestion(text, CssColor.known())));
    }
    return color;
  }

  private static boolean isTransparent(JsonNode options) {
    return SceneKeys.BACKGROUND.find(options).filter(n -> n.isText(TRANSPARENT)).isPresent();
  }

  /** Returns the light that the camera sees instead of environment lights; empty for none. */
  static Optional<Rgb> backplate(JsonNode options) {
    return options.find(Setting.BACKPLATE.name()).filter(JsonNode::isObject).map(JsonNode::rgb);
  }

  /** Returns the radiance of the background; empty if the scene names none. */
  static Optional<Rgb> background(JsonNode options) {
    Optional<JsonNode> node = SceneKeys.BACKGROUND.find(options);
    if (node.isEmpty() || isTransparent(options)) {
      return Optional.empty();
    }
    if (!node.get().isObject()) {
      node.get()
          .error(
              "expected an object such as %s or \"%s\", found %s"
                  .formatted(WHITE_LIGHT, TRANSPARENT, node.get().found()));
      return Optional.empty();
    }
    return Optional.of(node.get().rgb());
  }
}
