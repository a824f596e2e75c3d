package io.github.lumbre.cli.view;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

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
   * @throws IllegalArgumentException if it is not a number in the range
   */
  long number(String name, long low, long high, long fallback) {
    if (!values.containsKey(name)) {
      return fallback;
    }
    String found = values.get(name);
    try {
      long number = Long.parseLong(found);
      if (number >= low && number <= high) {
        return number;
      }
    } catch (NumberFormatException e) {
      // The message below is about any wrong value.
      throw wrong(name, low, high, found);
    }
    throw wrong(name, low, high, found);
  }

  private static IllegalArgumentException wrong(String name, long low, long high, String found) {
    return new IllegalArgumentException(
        name + ": expected " + low + " to " + high + ", found " + found);
  }
}
