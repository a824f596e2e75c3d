package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.internal.ModelNames;
import io.github.lumbre.model.internal.Warnings;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * Reads optional values of lights, cameras and materials. One that is wrong is replaced, with a
 * warning, so that it does not take the model away.
 *
 * @param owner whose values they are, such as {@code light}
 */
record GltfValues(Warnings warnings, String owner) {
  /** Returns a finite number. */
  double number(GltfJson json, String member, double fallback) {
    return json.find(member).map(value -> number(value, fallback)).orElse(fallback);
  }

  private double number(JsonValue value, double fallback) {
    if (GltfJson.isFinite(value)) {
      return value.number();
    }
    String location = new GltfJson(value).location();
    String expected = value.isNumber() ? "a finite number" : "a number";
    replaced(location, expected, value.found(), PrintableText.number(fallback));
    return fallback;
  }

  /**
   * Returns a number above 0; empty if there is none.
   *
   * @param instead what is used in place of a wrong one
   */
  OptionalDouble positive(GltfJson json, String member, String instead) {
    Optional<JsonValue> found = json.find(member);
    if (found.isEmpty()) {
      return OptionalDouble.empty();
    }
    JsonValue value = found.get();
    if (GltfJson.isFinite(value) && value.number() > 0) {
      return OptionalDouble.of(value.number());
    }
    replaced(json.location(member), "a number > 0", value.found(), instead);
    return OptionalDouble.empty();
  }

  /** Returns a number from 0 to a maximum; one out of this range is clamped. */
  double upTo(double max, GltfJson json, String member, double fallback) {
    return upTo(max, json.location(member), number(json, member, fallback));
  }

  private double upTo(double max, String location, double value) {
    return clamped(location, value, 0, max, max == 1 ? "0 to 1" : "at least 0");
  }

  /** Returns a number clamped to a range, which a text describes. */
  double clamped(String location, double value, double min, double max, String expected) {
    double inside = Math.max(min, Math.min(value, max));
    if (inside != value) {
      replaced(location, expected, PrintableText.number(value), PrintableText.number(inside));
    }
    return inside;
  }

  /** Returns as many finite numbers as there are in the default. */
  double[] numbers(GltfJson json, String member, double... fallback) {
    Optional<JsonValue> found = checked(json, member, JsonValue::isArray, "an array", fallback);
    double[] numbers = fallback.clone();
    if (found.isEmpty()) {
      return numbers;
    }
    List<JsonValue> items = found.get().elements();
    if (items.size() != numbers.length) {
      warnOfCount(json.location(member), items.size(), fallback);
    }
    for (int i = 0; i < Math.min(numbers.length, items.size()); i++) {
      numbers[i] = number(items.get(i), fallback[i]);
    }
    return numbers;
  }

  private void warnOfCount(String location, int found, double... fallback) {
    int expected = fallback.length;
    String used =
        found > expected
            ? "the first " + expected + " are used"
            : shown(Arrays.copyOfRange(fallback, found, expected)) + " is used for the others";
    warn(location, "expected %d numbers, found %d; %s".formatted(expected, found, used));
  }

  /** Returns a color whose components are clamped from 0 to a maximum, and what follows them. */
  double[] color(double max, GltfJson json, String member, double... fallback) {
    double[] color = numbers(json, member, fallback);
    for (int i = 0; i < 3; i++) {
      color[i] = upTo(max, json.location(member), color[i]);
    }
    return color;
  }

  /** Returns a member that is one of some texts, without regard to case. */
  String choice(GltfJson json, String member, List<String> choices, String fallback) {
    Optional<JsonValue> found = json.find(member);
    String text = found.filter(JsonValue::isString).map(JsonValue::text).orElse(fallback);
    String used =
        choices.stream().filter(text::equalsIgnoreCase).findFirst().orElse(fallback);
    if (found.isPresent() && !(found.get().isString() && used.equals(text))) {
      String expected = ModelNames.choice(choices);
      replaced(json.location(member), expected, found.get().found(), PrintableText.quoted(used));
    }
    return used;
  }

  /** Returns a member that is true or false. */
  boolean flag(GltfJson json, String member, boolean fallback) {
    return checked(json, member, JsonValue::isFlag, "true or false", fallback)
        .map(JsonValue::flag)
        .orElse(fallback);
  }

  /** Returns the name of an object; empty if it has none. */
  String name(GltfJson json) {
    return checked(json, "name", JsonValue::isString, "a text", "none")
        .map(JsonValue::text)
        .orElse("");
  }

  /** Returns a member that is an object. */
  Optional<GltfJson> object(GltfJson json, String member) {
    return checked(json, member, JsonValue::isObject, "an object", "none").map(GltfJson::new);
  }

  /** Returns an extension of an object. */
  Optional<GltfJson> extension(GltfJson json, String name) {
    return object(json, "extensions").flatMap(extensions -> object(extensions, name));
  }

  /** Returns a member of a type; empty, with a warning, if it is of another type. */
  private Optional<JsonValue> checked(
      GltfJson json, String member, Predicate<JsonValue> type, String expected, Object fallback) {
    Optional<JsonValue> found = json.find(member);
    if (found.isPresent() && !type.test(found.get())) {
      String shown = fallback instanceof double[] numbers ? shown(numbers) : fallback.toString();
      replaced(json.location(member), expected, found.get().found(), shown);
      return Optional.empty();
    }
    return found;
  }

  private static String shown(double... numbers) {
    return Arrays.stream(numbers).mapToObj(PrintableText::number).collect(Collectors.joining(", "));
  }

  /** Warns of a value that is replaced. */
  void replaced(String location, String expected, String found, String used) {
    warn(location, "expected %s, found %s; %s is used".formatted(expected, found, used));
  }

  /** Warns that the owner is left out, since it lacks what it needs. */
  void leftOut(GltfJson json, String member, String expected) {
    String found = json.find(member).map(JsonValue::found).orElse("nothing");
    warn(
        json.location(member),
        "expected %s, found %s; the %s is left out".formatted(expected, found, owner));
  }

  private void warn(String location, String message) {
    warnings.add("a value of a " + owner + " is wrong", location, message);
  }
}
