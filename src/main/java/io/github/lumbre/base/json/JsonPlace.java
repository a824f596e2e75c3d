package io.github.lumbre.base.json;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Where a reader of JSON is in its text.
 *
 * @param line from 1; 0 if unknown
 * @param column in characters, from 1, without a byte order mark; 0 if unknown
 */
public record JsonPlace(int line, int column) {
  private static final Pattern LOCATION = Pattern.compile("at line (\\d+) column (\\d+)");

  /**
   * Returns the place of a reader.
   *
   * @param reader the reader, or a message of it, as text
   */
  public static JsonPlace of(String reader) {
    Matcher matcher = LOCATION.matcher(reader);
    return matcher.find()
        ? new JsonPlace(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)))
        : new JsonPlace(0, 0);
  }

  /** Returns words for messages, such as {@code at line 3, column 7}. */
  @Override
  public String toString() {
    return line == 0 ? "at an unknown position" : "at line " + line + ", column " + column;
  }
}
