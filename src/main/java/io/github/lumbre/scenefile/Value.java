package io.github.lumbre.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.SettingType;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The type of a key's values: how they are read, written and described. Stateless.
 *
 * @param <T> the type in memory
 * @param reader empty, with an error added, for a wrong value
 * @param writer throws {@link Unwritable} for a value that scenes may not state
 * @param schema of JSON, in which ' stands for "
 */
record Value<T>(
    Function<JsonNode, Optional<T>> reader, Function<T, JsonElement> writer, String schema) {
  private static final Pattern WORD = Pattern.compile("-(.)");

  static final Value<Boolean> FLAG =
      new Value<>(JsonNode::flag, JsonPrimitive::new, "{'type': ['boolean', 'null']}");
  static final Value<Long> LONG =
      new Value<>(
          node -> node.integer(Long.MIN_VALUE, Long.MAX_VALUE),
          JsonPrimitive::new,
          integers(Long.MIN_VALUE, Long.MAX_VALUE));
  static final Value<Integer> ID =
      new Value<>(
          integer(Integer.MIN_VALUE, Integer.MAX_VALUE).reader(),
          JsonPrimitive::new,
          "{'$ref': '#/$defs/id'}");
  static final Value<String> TEXT = text("{'type': ['string', 'null']}");
  static final Value<Rgb> COLOR =
      new Value<>(
          JsonNode::rgb,
          color -> numbers("r", color.r(), "g", color.g(), "b", color.b()),
          "{'$ref': '#/$defs/color'}");

  /** Returns vectors, with the components of one that are missing. */
  static Value<Vec3> vector(Vec3 components) {
    return new Value<>(
        node -> node.vec3(components),
        vector -> numbers("x", vector.x(), "y", vector.y(), "z", vector.z()),
        "{'$ref': '#/$defs/vector'}");
  }

  /** Returns points of a plane, with the components of one that are missing. */
  static Value<Point2> point(Point2 components) {
    Value<Vec3> vector = vector(new Vec3(components.x(), components.y(), 0));
    return new Value<>(
        node -> vector.reader().apply(node).map(found -> new Point2(found.x(), found.y())),
        point -> numbers("x", point.x(), "y", point.y()),
        vector.schema());
  }

  /** Returns the numbers in a range. */
  static Value<Double> number(Range range) {
    return new Value<>(
        node -> node.number(range),
        value -> {
          if (!range.contains(value)) {
            throw new Unwritable(range.expectedFor(value), "" + value);
          }
          return new JsonPrimitive(value);
        },
        schema(range));
  }

  static Value<Integer> integer(int low, int high) {
    return new Value<>(
        node -> node.integer(low, high).map(Long::intValue),
        JsonPrimitive::new,
        integers(low, high));
  }

  /** Returns named values. */
  static <T> Value<T> choice(Map<String, T> choices) {
    return new Value<>(
        node -> node.choice(choices),
        value -> new JsonPrimitive(nameOf(value, choices)),
        "{'enum': [" + quoted(choices.keySet()) + ", null]}");
  }

  /** Returns values by their names, in their order. */
  static <T> Map<String, T> named(Function<T, String> naming, List<T> values) {
    Map<String, T> named = new LinkedHashMap<>();
    values.forEach(value -> named.put(naming.apply(value), value));
    return named;
  }

  /** Returns the name of a constant of one word with a capital, such as {@code Light}. */
  static String capitalized(Enum<?> constant) {
    return constant.name().charAt(0) + constant.name().substring(1).toLowerCase(Locale.ROOT);
  }

  /** Returns the name of a constant as keys are written, such as {@code inverseSquare}. */
  static String camelCase(Enum<?> constant) {
    String name = SettingType.nameOf(constant);
    return WORD.matcher(name).replaceAll(word -> word.group(1).toUpperCase(Locale.ROOT));
  }

  private static <T> String nameOf(T value, Map<String, T> choices) {
    return choices.keySet().stream()
        .filter(name -> choices.get(name).equals(value))
        .findFirst()
        .orElseThrow();
  }

  private static String quoted(Collection<String> names) {
    return names.stream().map(name -> "'" + name + "'").collect(Collectors.joining(", "));
  }

  /** Returns texts with a schema of their own. */
  static Value<String> text(String schema) {
    return new Value<>(JsonNode::string, JsonPrimitive::new, schema);
  }

  /** Returns arrays of numbers, of one of some lengths. */
  static Value<double[]> list(Integer... lengths) {
    String ofLength = "{'minItems': %1$s, 'maxItems': %1$s}";
    return new Value<>(
        node -> node.numbers(List.of(lengths)),
        value -> {
          JsonArray array = new JsonArray();
          Arrays.stream(value).forEach(array::add);
          return array;
        },
        "{'type': ['array', 'null'], 'items': {'type': 'number'}, 'anyOf': [%s]}"
            .formatted(
                Arrays.stream(lengths).map(ofLength::formatted).collect(Collectors.joining(", "))));
  }

  /** Returns values with readers and writers of their own. */
  static Value<JsonNode> other(String schema) {
    return new Value<>(Optional::of, value -> JsonNull.INSTANCE, schema);
  }

  private static JsonObject numbers(Object... keysAndNumbers) {
    JsonObject object = new JsonObject();
    for (int i = 0; i < keysAndNumbers.length; i += 2) {
      object.addProperty((String) keysAndNumbers[i], (Double) keysAndNumbers[i + 1]);
    }
    return object;
  }

  private static String integers(long low, long high) {
    return "{'type': ['integer', 'null'], 'minimum': %s, 'maximum': %s}".formatted(low, high);
  }

  /** Returns a range as its function accepts numbers: bounds may be excluded, or 0 be apart. */
  private static String schema(Range range) {
    String limits =
        limit(range, "inimum", range.low()) + limit(range, "aximum", range.high());
    if (range.contains(0) && range.low() > 0) {
      limits = ", 'anyOf': [{'const': 0}, {" + limits.substring(2) + "}]";
    } else if (!range.contains(0) && range.low() < 0 && range.high() > 0) {
      limits += ", 'not': {'const': 0}";
    }
    return "{'type': ['number', 'null']" + limits + "}";
  }

  private static String limit(Range range, String ending, double bound) {
    if (Math.abs(bound) >= Double.MAX_VALUE) {
      return "";
    }
    String start = range.contains(bound) ? "m" : "exclusiveM";
    return ", '%s%s': %s".formatted(start, ending, PrintableText.number(bound));
  }
}
