package io.github.lumbre.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import io.github.lumbre.base.text.Spelling;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.internal.OptionTypes.NamedType;
import io.github.lumbre.model.internal.OptionTypes.PoseType;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.SettingTypes.ChoiceType;
import io.github.lumbre.scene.internal.SettingTypes.ExposureType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.IntegerType;
import io.github.lumbre.scene.internal.SettingTypes.LongType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.scene.internal.SettingTypes.PowerType;
import io.github.lumbre.scene.internal.SettingTypes.ScreenColorType;
import java.util.List;
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
              RootKeys.OF_OPTIONS.stream().map(Key::name),
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
  static RenderSettings defaults(Optional<Mode> mode) {
    Mode used = mode.orElse(DEFAULT.mode());
    int samples = used == Mode.RAY ? raySamples(RootKeys.DEFAULT_ANTIALIASING) : DEFAULT.samples();
    return DEFAULT.toBuilder().mode(used).samples(samples).build();
  }

  private static <T> void read(
      Setting<T> setting, JsonNode options, RenderSettings.Builder builder) {
    builder.set(setting, key(setting).in(options));
  }

  /** Returns the key of a setting. */
  static <T> Key<T> key(Setting<T> setting) {
    return Key.of(setting.name(), value(setting.type()), setting.defaultValue(), setting.meaning());
  }

  /** Returns the values of a setting, or of an option of a model. */
  @SuppressWarnings("unchecked") // The type has the type of the values.
  static <T> Value<T> value(SettingType<T> type) {
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
              SettingsReader::screenColor,
              color -> new JsonPrimitive(screen.format(color)),
              "{'anyOf': [{'$ref': '#/$defs/color'}, {'$ref': '#/$defs/gradient'}, "
                  + "{'$ref': '#/$defs/screenColor'}]}");
    }
    if (type instanceof ExposureType) {
      return (Value<T>)
          new Value<Exposure>(
              SettingsReader::exposure,
              exposure ->
                  exposure.equals(Exposure.AUTO)
                      ? new JsonPrimitive(SettingType.AUTO)
                      : new JsonPrimitive(exposure.stops().getAsDouble()),
              "{'anyOf': [{'type': ['number', 'null']}, {'const': 'auto'}]}");
    }
    if (type instanceof NamedType<T> named) {
      return Value.choice(named.choices());
    }
    if (type instanceof PoseType) {
      return (Value<T>)
          new Value<Pose>(
              node -> node.string().map(name -> new Pose(name, 0)),
              pose -> new JsonPrimitive(pose.animation()),
              Value.TEXT.schema());
    }
    if (type instanceof TextsType texts) {
      return (Value<T>) texts(texts);
    }
    return new Value<>(
        node -> node.string().flatMap(text -> parsed(type, text, node)),
        value -> new JsonPrimitive(type.format(value)),
        Value.TEXT.schema());
  }

  private static <T> Optional<T> parsed(SettingType<T> type, String text, JsonNode node) {
    try {
      return Optional.of(type.parse(text));
    } catch (IllegalArgumentException e) {
      node.error(e.getMessage());
      return Optional.empty();
    }
  }

  private static Value<List<String>> texts(TextsType type) {
    return new Value<>(
        node -> {
          List<String> all = node.strings();
          List<String> refused = all.stream().filter(t -> !type.accepts(List.of(t))).toList();
          refused.forEach(text -> node.error(type.refusal(List.of(text))));
          return Optional.of(all).filter(texts -> refused.isEmpty());
        },
        texts -> {
          JsonArray array = new JsonArray();
          texts.forEach(array::add);
          return array;
        },
        "{'type': ['array', 'null'], 'items': {'type': 'string'}}");
  }

  private static Value<Integer> power(PowerType type) {
    String powers =
        IntStream.rangeClosed(1, type.high())
            .filter(type::accepts)
            .mapToObj(Integer::toString)
            .collect(Collectors.joining(", "));
    return new Value<>(
        node -> {
          Optional<Integer> value = node.integer(1, type.high()).map(Long::intValue);
          value
              .filter(number -> !type.accepts(number))
              .ifPresent(n -> node.error("expected " + type.expected() + ", found " + n));
          return value.filter(type::accepts);
        },
        JsonPrimitive::new,
        "{'enum': [" + powers + ", null]}");
  }

  /**
   * Returns the number of samples for the format's exponent of two. Odd exponents do not exist: the
   * numbers are 1, 4, 16, …
   */
  private static int raySamples(int exponent) {
    return 1 << exponent + exponent % 2;
  }

  private static int raySamples(JsonNode options) {
    int n = RootKeys.ANTIALIASING.in(options);
    return raySamples(n == -1 ? RootKeys.DEFAULT_ANTIALIASING : n);
  }

  private static Optional<Exposure> exposure(JsonNode node) {
    if (node.isText(SettingType.AUTO)) {
      return Optional.of(Exposure.AUTO);
    }
    if (!node.isNumber()) {
      node.error("expected a finite number or \"auto\", found " + node.found());
    }
    return Optional.of(node).filter(JsonNode::isNumber)
        .flatMap(number -> number.number(Range.ANY))
        .map(Exposure::of);
  }

  /** Returns a color of the screen; no color for an object, the light of {@link #backplate}. */
  private static Optional<Optional<Rgb>> screenColor(JsonNode node) {
    String text = node.text().orElse("");
    Optional<Rgb> color = CssColor.of(text);
    if (!node.isObject() && color.isEmpty()) {
      node.error(
          "expected light such as %s, or %s, found %s%s"
              .formatted(
                  WHITE_LIGHT,
                  Setting.BACKPLATE.type().expected(),
                  node.found(),
                  Spelling.suggestion(text, CssColor.known())));
    }
    return Optional.of(color);
  }

  private static boolean isTransparent(JsonNode options) {
    return RootKeys.BACKGROUND.find(options).filter(n -> n.isText(TRANSPARENT)).isPresent();
  }

  /** Returns the light that the camera sees instead of environment lights; empty for none. */
  static Optional<Backplate> backplate(JsonNode options) {
    return options
        .find(Setting.BACKPLATE.name())
        .filter(JsonNode::isObject)
        .flatMap(
            node ->
                isGradient(node)
                    ? Optional.of(gradient(node))
                    : node.rgb().map(Backplate::plain));
  }

  private static boolean isGradient(JsonNode backplate) {
    return RootKeys.OF_GRADIENTS.stream().anyMatch(key -> key.isIn(backplate));
  }

  private static Backplate gradient(JsonNode backplate) {
    backplate.warnUnknown(Key.names(RootKeys.OF_GRADIENTS));
    return shadowed(
        new Backplate(RootKeys.TOP.in(backplate), RootKeys.BOTTOM.in(backplate)), backplate);
  }

  private static Backplate shadowed(Backplate light, JsonNode backplate) {
    if (!RootKeys.SHADOW_MIN.isIn(backplate) && !RootKeys.SHADOW_MAX.isIn(backplate)) {
      return light;
    }
    Bounds3 box = new Bounds3(RootKeys.SHADOW_MIN.in(backplate), RootKeys.SHADOW_MAX.in(backplate));
    if (box.isEmpty()) {
      RootKeys.SHADOW_MAX.error(
          backplate, "expected at least shadowMin on each axis, found less");
      return light;
    }
    return light.withShadowOf(box);
  }

  /** Returns the value of a key that {@link #backplate} reads. */
  static JsonElement written(Backplate backplate) {
    if (backplate.isPlain() && backplate.shadowOf().isEmpty()) {
      return Value.COLOR.writer().apply(backplate.top());
    }
    JsonObject gradient = new JsonObject();
    RootKeys.TOP.put(gradient, backplate.top());
    RootKeys.BOTTOM.put(gradient, backplate.bottom());
    backplate
        .shadowOf()
        .ifPresent(
            box -> {
              RootKeys.SHADOW_MIN.put(gradient, box.min());
              RootKeys.SHADOW_MAX.put(gradient, box.max());
            });
    return gradient;
  }

  /** Returns the radiance of the background; empty if the scene names none. */
  static Optional<Rgb> background(JsonNode options) {
    Optional<JsonNode> node = RootKeys.BACKGROUND.find(options);
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
    return node.get().rgb();
  }
}
