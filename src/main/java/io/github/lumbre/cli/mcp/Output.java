package io.github.lumbre.cli.mcp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A member of the structured content of results: its schema in JSON Schema 2020-12. More members
 * may be added later, so that schemas do not forbid others.
 *
 * @param isRequired whether results always have it
 */
record Output(String name, Map<String, Object> schema, boolean isRequired) {
  private static final String TYPE = "type";

  Output {
    schema = frozen(schema);
  }

  /** Returns an immutable copy of a schema. */
  private static Map<String, Object> frozen(Map<String, Object> schema) {
    Map<String, Object> copy = new LinkedHashMap<>();
    schema.forEach((key, value) -> copy.put(key, frozen(value)));
    return Collections.unmodifiableMap(copy);
  }

  @SuppressWarnings("unchecked") // The keys of schemas are texts.
  private static Object frozen(Object value) {
    if (value instanceof Map<?, ?> members) {
      return frozen((Map<String, Object>) members);
    }
    return value instanceof List<?> elements ? List.copyOf(elements) : value;
  }

  static Output text(String name, String description) {
    return new Output(name, schema("string", description), true);
  }

  static Output number(String name, String description) {
    return new Output(name, schema("number", description), true);
  }

  /** Returns an integer that is not negative. */
  static Output count(String name, String description) {
    Map<String, Object> schema = schema("integer", description);
    schema.put("minimum", 0);
    return new Output(name, schema, true);
  }

  static Output texts(String name, String description) {
    return list(name, schema("string", ""), description);
  }

  /** Returns a list of so many numbers. */
  static Output numbers(String name, int count, String description) {
    Map<String, Object> schema = numbers(count);
    schema.put("description", description);
    return new Output(name, schema, true);
  }

  /** Returns a list of so many lists of so many numbers. */
  static Output rows(String name, int rows, int columns, String description) {
    Map<String, Object> schema = schema("array", description);
    schema.put("items", numbers(columns));
    return new Output(name, bounded(schema, rows), true);
  }

  /** Returns a list of objects with members. */
  static Output objects(String name, String description, Output... members) {
    return list(name, object(Arrays.asList(members)), description);
  }

  /** Returns an object with texts by names that depend on the result. */
  static Output textsByName(String name, String description) {
    Map<String, Object> schema = schema("object", description);
    schema.put("additionalProperties", schema("string", ""));
    return new Output(name, schema, true);
  }

  /** Returns an object whose members are described elsewhere. */
  static Output open(String name, String description) {
    Map<String, Object> schema = schema("object", description);
    schema.put("additionalProperties", true);
    return new Output(name, schema, true);
  }

  /** Returns this member, which results may lack. */
  Output optional() {
    return new Output(name, schema, false);
  }

  /** Returns the schema of an object with members. */
  static Map<String, Object> object(List<Output> members) {
    Map<String, Object> properties = new LinkedHashMap<>();
    List<String> required = new ArrayList<>();
    for (Output member : members) {
      properties.put(member.name, member.schema);
      if (member.isRequired) {
        required.add(member.name);
      }
    }
    Map<String, Object> schema = schema("object", "");
    schema.put("properties", properties);
    schema.put("required", required);
    return schema;
  }

  private static Output list(String name, Map<String, Object> items, String description) {
    Map<String, Object> schema = schema("array", description);
    schema.put("items", items);
    return new Output(name, schema, true);
  }

  private static Map<String, Object> numbers(int count) {
    Map<String, Object> schema = schema("array", "");
    schema.put("items", schema("number", ""));
    return bounded(schema, count);
  }

  private static Map<String, Object> bounded(Map<String, Object> schema, int count) {
    schema.put("minItems", count);
    schema.put("maxItems", count);
    return schema;
  }

  private static Map<String, Object> schema(String type, String description) {
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put(TYPE, type);
    if (!description.isEmpty()) {
      schema.put("description", description);
    }
    return schema;
  }
}
