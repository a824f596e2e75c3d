package io.github.lumbre.parser;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.model.ModelOptions;
import java.util.List;
import java.util.Locale;

/** Values of scene files that are written. */
final class Written {
  private Written() {}

  /** Adds what a model object reads of its file; defaults are left out. */
  static void options(JsonObject object, ModelOptions options) {
    options.up().ifPresent(up -> object.addProperty("up", up.name().toLowerCase(Locale.ROOT)));
    options.unit().ifPresent(unit -> object.addProperty("unit", unit));
    options.pointRadius().ifPresent(radius -> object.addProperty("pointRadius", radius));
    if (!options.sections().isEmpty()) {
      JsonArray sections = new JsonArray();
      options.sections().forEach(sections::add);
      object.add("section", sections);
    }
    options
        .pose()
        .ifPresent(
            pose -> {
              object.addProperty("pose", pose.animation());
              object.addProperty("seconds", pose.seconds());
            });
    options.variant().ifPresent(variant -> object.addProperty("variant", variant));
    if (!options.look().isEmpty()) {
      object.addProperty("look", options.look());
    }
    names(object, "hide", options.hidden());
    names(object, "highlight", options.highlighted());
  }

  private static void names(JsonObject object, String key, List<String> names) {
    if (!names.isEmpty()) {
      JsonArray array = new JsonArray();
      names.forEach(array::add);
      object.add(key, array);
    }
  }

  /** Returns the name of the class of a thing that the format does not have. */
  static String name(Object thing) {
    String name = thing.getClass().getSimpleName();
    return name.isEmpty() || thing.getClass().isSynthetic() ? "one that code computes" : name;
  }
}
