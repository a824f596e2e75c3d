package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An argument of tools, declared once: its schema and the check of its value.
 *
 * @param schema in JSON Schema 2020-12
 * @param reader turns JSON into a value
 * @param expects what the reader accepts, for messages
 * @param defaultValue the value of a missing argument; empty if the argument is required
 */
record Input<T>(
    String name,
    Map<String, Object> schema,
    Reader<T> reader,
    String expects,
    Optional<T> defaultValue) {
  private static final int MOST_TEXT = 4096;
  private static final int MOST_ELEMENTS = 64;
  private static final String TEXT = "a string of at most " + MOST_TEXT + " characters";

  /** Turns JSON into a value. */
  @FunctionalInterface
  interface Reader<T> {
    /** Returns the value; empty if it is none of the kind that is expected. */
    Optional<T> read(JsonValue value);
  }

  /** Returns a text that must be given. */
  static Input<String> requiredText(String name, String description) {
    return new Input<>(name, schema("string", description), Input::text, TEXT, Optional.empty());
  }

  /** Returns a text that may be missing. */
  static Input<Optional<String>> text(String name, String description) {
    return new Input<>(
        name,
        schema("string", description),
        value -> text(value).map(Optional::of),
        TEXT,
        Optional.of(Optional.empty()));
  }

  /** Returns a list of texts, which is empty if it is missing. */
  static Input<List<String>> texts(String name, String description) {
    Map<String, Object> schema = schema("array", description);
    schema.put("items", Map.of("type", "string"));
    schema.put("maxItems", MOST_ELEMENTS);
    String expects = "an array of at most " + MOST_ELEMENTS + " strings";
    return new Input<>(name, schema, Input::texts, expects, Optional.of(List.of()));
  }

  static Input<Integer> integer(
      String name, int least, int most, int defaultValue, String description) {
    return new Input<>(
        name,
        bounds(schema("integer", description), least, most, defaultValue),
        value -> value.exactLong().filter(n -> n >= least && n <= most).map(n -> (int) (long) n),
        "an integer from " + least + " to " + most,
        Optional.of(defaultValue));
  }

  /** Returns an integer that must be given. */
  static Input<Integer> requiredInteger(String name, int least, int most, String description) {
    Input<Integer> input = integer(name, least, most, least, description);
    input.schema.remove("default");
    return new Input<>(name, input.schema, input.reader, input.expects, Optional.empty());
  }

  /** Returns a number that may be missing. */
  static Input<Optional<Double>> number(String name, NumberType type, String description) {
    Map<String, Object> schema = schema("number", description);
    Range range = type.range();
    schema.put(range.contains(range.low()) ? "minimum" : "exclusiveMinimum", range.low());
    schema.put(range.contains(range.high()) ? "maximum" : "exclusiveMaximum", range.high());
    return new Input<>(
        name,
        schema,
        value ->
            Optional.of(value)
                .filter(JsonValue::isNumber)
                .map(JsonValue::number)
                .filter(type::accepts)
                .map(Optional::of),
        type.expected(),
        Optional.of(Optional.empty()));
  }

  /** Returns a flag, which is false if it is missing. */
  static Input<Boolean> flag(String name, String description) {
    Map<String, Object> schema = schema("boolean", description);
    schema.put("default", false);
    return new Input<>(
        name,
        schema,
        value -> value.isFlag() ? Optional.of(value.flag()) : Optional.empty(),
        "true or false",
        Optional.of(false));
  }

  private static Map<String, Object> schema(String type, String description) {
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put("type", type);
    schema.put("description", description);
    return schema;
  }

  private static Map<String, Object> bounds(
      Map<String, Object> schema, int least, int most, int defaultValue) {
    schema.put("minimum", least);
    schema.put("maximum", most);
    schema.put("default", defaultValue);
    return schema;
  }

  private static Optional<String> text(JsonValue value) {
    return value.isString() && value.text().length() <= MOST_TEXT
        ? Optional.of(value.text())
        : Optional.empty();
  }

  private static Optional<List<String>> texts(JsonValue value) {
    if (!value.isArray() || value.elements().size() > MOST_ELEMENTS) {
      return Optional.empty();
    }
    List<String> texts = new ArrayList<>();
    for (JsonValue element : value.elements()) {
      text(element).ifPresent(texts::add);
    }
    return texts.size() == value.elements().size() ? Optional.of(texts) : Optional.empty();
  }

  boolean isRequired() {
    return defaultValue.isEmpty();
  }

  /** Returns what is expected, for messages. */
  String expected() {
    return name + ": expected " + expects;
  }
}
