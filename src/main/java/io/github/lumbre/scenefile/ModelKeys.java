package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.internal.OptionTypes.PoseType;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Reads and writes the options of a model as keys of its object. Stateless. */
final class ModelKeys {
  private static final Key<Double> SECONDS =
      Key.of("seconds", SettingsReader.value(PoseType.SECONDS), 0., "Time in the animation.");

  private static final List<ModelOption<?>> OPTIONS =
      ModelOption.all().stream().filter(ModelOption::isInScenes).toList();

  /** The keys; those of poses are two. */
  static final List<Key<?>> ALL =
      OPTIONS.stream()
          .<Key<?>>flatMap(
              option ->
                  option == ModelOption.POSE
                      ? Stream.of(key(option), SECONDS)
                      : Stream.of(key(option)))
          .toList();

  private ModelKeys() {}

  private static <T> Key<T> key(ModelOption<T> option) {
    return Key.of(option.name(), SettingsReader.value(option.type()), option.help());
  }

  /** Returns the options of an object. The default replaces each wrong one; an error is added. */
  static ModelOptions read(JsonNode node) {
    ModelOptions options = ModelOptions.DEFAULT;
    for (ModelOption<?> option : OPTIONS) {
      options = read(option, node, options);
    }
    Optional<Pose> pose = options.find(ModelOption.POSE);
    return pose.isEmpty()
        ? options
        : options.with(ModelOption.POSE, new Pose(pose.get().animation(), SECONDS.in(node)));
  }

  private static <T> ModelOptions read(ModelOption<T> option, JsonNode node, ModelOptions to) {
    return key(option).stated(node).map(value -> to.with(option, value)).orElse(to);
  }

  /** Adds the options to an object; defaults are left out. */
  static void write(ModelOptions options, JsonObject object) {
    OPTIONS.forEach(option -> write(option, options, object));
  }

  private static <T> void write(ModelOption<T> option, ModelOptions options, JsonObject object) {
    Optional<T> value =
        options.find(option).filter(v -> !Optional.of(v).equals(option.defaultValue()));
    value.ifPresent(stated -> key(option).put(object, stated));
    if (value.isPresent() && value.get() instanceof Pose pose) {
      SECONDS.put(object, pose.seconds());
    }
  }
}
