package io.github.lumbre.cli.view;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** The parameters of a request by name. */
record Query(Map<String, String> values) {
  /**
   * Returns the parameters of an encoded query.
   *
   * @throws IllegalArgumentException if it is malformed
   */
  static Query of(String encoded) {
    Map<String, String> values = new LinkedHashMap<>();
    for (String part : encoded.split("&")) {
      int equals = part.indexOf('=');
      if (equals > 0) {
        values.put(decoded(part.substring(0, equals)), decoded(part.substring(equals + 1)));
      }
    }
    return new Query(values);
  }

  private static String decoded(String text) {
    return URLDecoder.decode(text, StandardCharsets.UTF_8);
  }

  Optional<String> text(String name) {
    return Optional.ofNullable(values.get(name));
  }

  /**
   * Returns a whole number.
   *
   * @throws IllegalArgumentException if it is not a whole number in the range
   */
  long number(String name, long low, long high, long fallback) {
    return (long) value(name, low, high, fallback, Long::parseLong);
  }

  /**
   * Returns a number.
   *
   * @throws IllegalArgumentException if it is not a number in the range
   */
  double decimal(String name, long low, long high, double fallback) {
    return value(name, low, high, fallback, Double::parseDouble);
  }

  private double value(
      String name, long low, long high, double fallback, ToDoubleFunction<String> parser) {
    if (!values.containsKey(name)) {
      return fallback;
    }
    String found = values.get(name);
    try {
      double value = parser.applyAsDouble(found);
      if (value >= low && value <= high) {
        return value;
      }
    } catch (NumberFormatException e) {
      // The message below is about any wrong value.
      throw wrong(name, low, high, found);
    }
    throw wrong(name, low, high, found);
  }

  private static IllegalArgumentException wrong(String name, long low, long high, String found) {
    return new IllegalArgumentException(
        "%s: expected a number from %d to %d, found %s".formatted(name, low, high, found));
  }
}
