package io.github.lumbre.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.internal.OptionTypes.NamedType;
import io.github.lumbre.model.internal.OptionTypes.PoseType;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Reads and writes the options of a model as keys of its object. Stateless. */
final class ModelKeys {
  private static final String SECONDS = "seconds";

  private static final List<ModelOption<?>> OPTIONS =
      ModelOption.all().stream().filter(ModelOption::isInScenes).toList();

  /** The names of the keys. */
  static final Set<String> NAMES =
      Stream.concat(OPTIONS.stream().map(ModelOption::name), Stream.of(SECONDS))
          .collect(Collectors.toUnmodifiableSet());

  private ModelKeys() {}

  /** Returns the options of an object. The default replaces each wrong one; an error is added. */
  static ModelOptions read(JsonNode node) {
    ModelOptions options = ModelOptions.DEFAULT;
    for (ModelOption<?> option : OPTIONS) {
      options = read(option, node, options);
    }
    return options;
  }

  private static <T> ModelOptions read(ModelOption<T> option, JsonNode node, ModelOptions to) {
    return value(option, node).map(value -> to.with(option, value)).orElse(to);
  }

  @SuppressWarnings("unchecked") // The option's type has the type of the values.
  private static <T> Optional<T> value(ModelOption<T> option, JsonNode node) {
    String key = option.name();
    if (option.type() instanceof NumberType range) {
      double number = node.number(key, Double.NaN, range.range());
      return (Optional<T>) Optional.of(number).filter(range::accepts);
    }
    if (option.type() instanceof NamedType<T> named) {
      return node.choice(key, named.choices());
    }
    if (option.type() instanceof TextsType texts) {
      return (Optional<T>) Optional.of(texts(node, key, texts));
    }
    Optional<String> text = node.string(key);
    if (option.type() instanceof PoseType) {
      return (Optional<T>) text.map(name -> pose(name, node));
    }
    try {
      return text.map(option.type()::parse);
    } catch (IllegalArgumentException e) {
      node.error(key, e.getMessage());
      return Optional.empty();
    }
  }

  private static List<String> texts(JsonNode node, String key, TextsType type) {
    List<String> texts = node.strings(key);
    texts.stream()
        .filter(text -> !type.accepts(List.of(text)))
        .forEach(text -> node.error(key, type.refusal(List.of(text))));
    return texts.stream().filter(text -> type.accepts(List.of(text))).toList();
  }

  private static Pose pose(String name, JsonNode node) {
    return new Pose(name, node.number(SECONDS, 0, PoseType.SECONDS.range()));
  }

  /** Adds the options to an object; defaults are left out. */
  static void write(ModelOptions options, JsonObject object) {
    OPTIONS.forEach(option -> write(option, options, object));
  }

  private static <T> void write(ModelOption<T> option, ModelOptions options, JsonObject object) {
    Optional<T> value = options.find(option).filter(v -> !Optional.of(v).equals(option.missing()));
    if (value.isEmpty()) {
      return;
    }
    if (value.get() instanceof Double number) {
      object.addProperty(option.name(), number);
    } else if (value.get() instanceof List<?> texts) {
      JsonArray array = new JsonArray();
      texts.forEach(text -> array.add((String) text));
      object.add(option.name(), array);
    } else if (value.get() instanceof Pose pose) {
      object.addProperty(option.name(), pose.animation());
      object.addProperty(SECONDS, pose.seconds());
    } else {
      object.addProperty(option.name(), option.type().format(value.get()));
    }
  }
}
