package io.github.lumbre.lab;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.TextFile;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
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
   * Returns the rows of a file whose first line is a header.
   *
   * @param reader makes a row from as many values as the header has; it may throw an {@link
   *     IllegalArgumentException}
   * @throws TaskException that names the line, with the exit code of an invalid command line, if
   *     the file cannot be read or a line is invalid
   */
  public static <T> List<T> read(Path file, String header, Function<List<String>, T> reader)
      throws TaskException {
    List<String> lines = TextFile.lines(file);
    if (lines.isEmpty() || !lines.get(0).equals(header)) {
      throw ExitCode.USAGE.failure(file + ": line 1: expected " + header);
    }
    int columns = values(header).size();
    List<T> rows = new ArrayList<>();
    for (int i = 1; i < lines.size(); i++) {
      try {
        List<String> values = values(lines.get(i));
        if (values.size() != columns) {
          throw new IllegalArgumentException(
              "expected " + columns + " values, found " + values.size());
        }
        rows.add(reader.apply(values));
      } catch (IllegalArgumentException e) {
        throw ExitCode.USAGE.failure(file + ": line " + (i + 1) + ": " + e.getMessage(), e);
      }
    }
    return rows;
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
