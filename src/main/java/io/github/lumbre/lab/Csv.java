package io.github.lumbre.lab;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Lines of comma-separated values by RFC 4180, without values that span several lines. */
public final class Csv {
  private Csv() {}

  /** Returns the values as a line without its line break, quoted where necessary. */
  public static String line(List<?> values) {
    return values.stream().map(String::valueOf).map(Csv::quoted).collect(Collectors.joining(","));
  }

  private static String quoted(String value) {
    boolean plain = value.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? value : '"' + value.replace("\"", "\"\"") + '"';
  }

  /**
   * Returns the values of a line.
   *
   * @throws IllegalArgumentException if a closing quote is missing
   */
  public static List<String> values(String line) {
    List<String> values = new ArrayList<>();
    StringBuilder value = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"' && quoted && line.startsWith("\"\"", i)) {
        value.append(c);
        i++;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        values.add(value.toString());
        value.setLength(0);
      } else {
        value.append(c);
      }
    }
    if (quoted) {
      throw new IllegalArgumentException("expected a closing quote");
    }
    values.add(value.toString());
    return values;
  }
}
