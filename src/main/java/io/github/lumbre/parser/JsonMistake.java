package io.github.lumbre.parser;

import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names frequent mistakes in JSON that is written by hand. */
final class JsonMistake {
  private static final String UNKNOWN = "a syntax error";
  private static final Pattern WORD = Pattern.compile("\\G-?([A-Za-z_]\\w{0,40})");
  private static final Pattern TRAILING_COMMA = Pattern.compile(",\\s*[}\\]]$");

  private JsonMistake() {}

  /**
   * Returns what was found.
   *
   * @param text in UTF-8
   * @param line of the place where Gson stopped, from 1
   * @param column of the place where Gson stopped, from 1
   * @param message Gson's
   */
  static String of(byte[] text, int line, int column, String message) {
    String all = new String(text, StandardCharsets.UTF_8);
    int start = 0;
    for (int i = 1; i < line; i++) {
      start = all.indexOf('\n', start) + 1;
    }
    int at = Math.min(all.length(), start + column - 1);
    String before = all.substring(Math.max(0, at - 1000), at);
    if (TRAILING_COMMA.matcher(before).find()) {
      return "a comma after the last element";
    }
    if (before.endsWith("/") || before.endsWith("#")) {
      return "a comment, which JSON does not have,";
    }
    if (before.endsWith("'")) {
      return "single quotes instead of double quotes";
    }
    if (message.startsWith("Expected ':'")) {
      return "no colon after a key";
    }
    if (message.startsWith("Unterminated string")) {
      return "a string without its closing quotes";
    }
    if (message.startsWith("Unterminated")) {
      return "no comma between two elements";
    }
    return word(all, at);
  }

  /** Returns the word without quotes that begins where Gson stopped, or one character before. */
  private static String word(String all, int at) {
    Matcher matcher = WORD.matcher(all);
    for (int start = at; start >= Math.max(0, at - 1); start--) {
      if (matcher.find(start)) {
        return matcher.group() + " without double quotes";
      }
    }
    return UNKNOWN;
  }
}
