package io.github.lumbre.base.json;

import io.github.lumbre.base.text.PrintableText;
import java.math.BigDecimal;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A value of a JSON text that knows its path. Immutable once {@link JsonTree} has read the text;
 * values are equal if they are the same.
 */
public final class JsonValue {
  /** All integers of this many characters fit into 64 bits. */
  private static final int SAFE_DIGITS = 18;

  /** A JSON number: its text and its nearest double. */
  private record Literal(String text, double value) {}

  private enum Null {
    INSTANCE
  }

  /** Null for the outermost value. */
  private final JsonValue parent;

  private final String key;
  private final int index;
  private final int position;
  private final Object value;

  private JsonValue(Optional<JsonValue> parent, String key, int position, Object value) {
    this.parent = parent.orElse(null);
    this.key = key;
    index = parent.filter(JsonValue::isArray).map(array -> array.elements().size()).orElse(-1);
    this.position = position;
    this.value = value;
  }

  /** Creates the values of one object or array; the outermost value has no parent. */
  record Maker(Optional<JsonValue> parent, String key, int position) {
    private JsonValue value(Object value) {
      return new JsonValue(parent, key, position, value);
    }

    JsonValue object() {
      return value(new LinkedHashMap<String, JsonValue>());
    }

    JsonValue array() {
      return value(new ArrayList<JsonValue>());
    }

    JsonValue string(String text) {
      return value(text);
    }

    JsonValue number(String text) {
      return value(new Literal(text, Double.parseDouble(text)));
    }

    JsonValue flag(boolean flag) {
      return value(flag);
    }

    JsonValue nothing() {
      return value(Null.INSTANCE);
    }
  }

  /**
   * Adds a child to an object or array under construction. Returns the earlier value of the same
   * key; empty if there is none.
   */
  Optional<JsonValue> add(JsonValue child) {
    if (isArray()) {
      elements().add(child);
      return Optional.empty();
    }
    return Optional.ofNullable(members().putIfAbsent(child.key, child));
  }

  /** Returns the number of keys in the text up to this value. */
  int position() {
    return position;
  }

  /** Returns the key of this value in its object; empty for others. */
  public String key() {
    return key;
  }

  public boolean isObject() {
    return value instanceof Map;
  }

  public boolean isArray() {
    return value instanceof List;
  }

  public boolean isNumber() {
    return value instanceof Literal;
  }

  public boolean isString() {
    return value instanceof String;
  }

  public boolean isFlag() {
    return value instanceof Boolean;
  }

  public boolean isNull() {
    return value == Null.INSTANCE;
  }

  /** Returns whether this is a number that overflows. */
  public boolean isInfinite() {
    return value instanceof Literal literal && Double.isInfinite(literal.value);
  }

  /** Returns the number nearest to this one; for numbers only. */
  public double number() {
    return ((Literal) value).value;
  }

  /** Returns this value as a 64-bit integer; empty if it is not one. */
  public Optional<Long> exactLong() {
    if (!isNumber() || isInfinite()) {
      return Optional.empty();
    }
    try {
      String text = text();
      // The first decimal makes Java compute tables, which takes 20 ms.
      return Optional.of(
          isShortInteger(text) ? Long.parseLong(text) : new BigDecimal(text).longValueExact());
    } catch (ArithmeticException e) {
      return Optional.empty();
    }
  }

  /** Returns whether a number has only digits, and few enough for 64 bits. */
  private static boolean isShortInteger(String number) {
    for (int i = 0; i < number.length(); i++) {
      char c = number.charAt(i);
      if ((c < '0' || c > '9') && (c != '-' || i != 0)) {
        return false;
      }
    }
    return number.length() <= SAFE_DIGITS;
  }

  /** Returns the text of a string or number, without quotes; for these only. */
  public String text() {
    return value instanceof Literal literal ? literal.text : (String) value;
  }

  /** Returns true or false; for these only. */
  public boolean flag() {
    return (Boolean) value;
  }

  /** Returns the values of an object by their keys, in the order of the text; for objects only. */
  @SuppressWarnings("unchecked") // Maker makes these maps.
  public Map<String, JsonValue> members() {
    return (Map<String, JsonValue>) value;
  }

  /** Returns the values of an array; for arrays only. */
  @SuppressWarnings("unchecked") // Maker makes these lists.
  public List<JsonValue> elements() {
    return (List<JsonValue>) value;
  }

  /** Returns the path, such as {@code $.objects[3].radius}. */
  public String path() {
    Deque<JsonValue> way = new ArrayDeque<>();
    for (JsonValue each = this; each.parent != null; each = each.parent) {
      way.push(each);
    }
    StringBuilder path = new StringBuilder("$");
    for (JsonValue each : way) {
      if (each.index >= 0) {
        path.append('[').append(each.index).append(']');
      } else {
        path.append('.').append(PrintableText.shortened(each.key));
      }
    }
    return path.toString();
  }

  /** Returns the value as text for an error message. */
  public String found() {
    if (isString()) {
      return PrintableText.quoted(text());
    }
    if (isNumber()) {
      return PrintableText.shortened(text());
    }
    return isNull() ? "null" : isObject() ? "an object" : isArray() ? "an array" : value.toString();
  }
}
