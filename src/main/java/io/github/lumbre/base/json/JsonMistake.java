package io.github.lumbre.base.json;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names frequent mistakes in JSON that is written by hand. */
public final class JsonMistake {
  private static final String UNKNOWN = "a syntax error";
  private static final Pattern WORD = Pattern.compile("\\G-?([A-Za-z_]\\w{0,40})");
  private static final Pattern TRAILING_COMMA = Pattern.compile(",\\s*[}\\]]$");

  /** How many bytes are looked at before and after the place. */
  private static final int AROUND = 1000;

  private JsonMistake() {}

  /**
   * Returns what was found instead of JSON, and where.
   *
   * @param text in UTF-8 up to the place, with or without a byte order mark
   * @param place where Gson stopped
   * @param message Gson's
   */
  public static String of(ByteBuffer text, JsonPlace place, String message) {
    return (place.line() == 0 ? UNKNOWN : name(text, place, message)) + " " + place;
  }

  private static String name(ByteBuffer text, JsonPlace place, String message) {
    int at = index(text, place);
    String before = decoded(text, Math.max(text.position(), at - AROUND), at);
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
    String after = decoded(text, at, Math.min(text.limit(), at + AROUND));
    return word(before + after, before.length());
  }

  /** Returns the index of the byte at a place; the text beyond is not looked at. */
  private static int index(ByteBuffer text, JsonPlace place) {
    int at = text.position();
    for (int line = 1; line < place.line() && at < text.limit(); at++) {
      line += text.get(at) == '\n' ? 1 : 0;
    }
    if (place.line() == 1 && startsWithMark(text)) {
      at += 3;
    }
    for (int column = 1; column < place.column() && at < text.limit(); ) {
      // A character of four bytes counts twice, as in Java's strings.
      column += (text.get(at) & 0xff) >= 0xf0 ? 2 : 1;
      at++;
      while (at < text.limit() && (text.get(at) & 0xc0) == 0x80) {
        at++;
      }
    }
    return at;
  }

  private static boolean startsWithMark(ByteBuffer text) {
    return decoded(text, text.position(), Math.min(text.limit(), text.position() + 3))
        .equals("\ufeff");
  }

  private static String decoded(ByteBuffer text, int from, int to) {
    return StandardCharsets.UTF_8.decode(text.slice(from, to - from)).toString();
  }

  /** Returns the word without quotes that begins where Gson stopped, or one character before. */
  private static String word(String text, int at) {
    Matcher matcher = WORD.matcher(text);
    for (int start = at; start >= Math.max(0, at - 1); start--) {
      if (matcher.find(start)) {
        return matcher.group() + " without double quotes";
      }
    }
    return UNKNOWN;
  }
}
