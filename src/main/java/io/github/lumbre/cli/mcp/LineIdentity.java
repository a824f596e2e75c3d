package io.github.lumbre.cli.mcp;

import java.util.Arrays;
import java.util.Optional;

/**
 * Finds the identity of a request in a line that is not JSON, is cut off, or has a key twice, so
 * that its error can be matched with it. Mutable; confined to one thread.
 */
final class LineIdentity {
  private static final String KEY = "\"id\"";

  private final byte[] line;
  private int at;
  private Optional<Object> found = Optional.empty();
  private boolean isAmbiguous;

  private LineIdentity(byte[] line) {
    this.line = line;
  }

  /**
   * Returns the value of {@code id} in the outermost object.
   *
   * @return empty if there is none, or several different ones
   */
  static Optional<Object> of(byte[] line) {
    return new LineIdentity(line).find();
  }

  private Optional<Object> find() {
    int depth = 0;
    while (at < line.length) {
      int start = at;
      byte c = line[at++];
      if (c == '"') {
        skipString();
        if (depth == 1 && isKey(start)) {
          readIdentity();
        }
      } else if (c == '{' || c == '[') {
        depth += c == '[' && depth == 0 ? 2 : 1; // The messages of a batch have no common identity.
      } else if (c == '}' || c == ']') {
        depth--;
      }
    }
    return isAmbiguous ? Optional.empty() : found;
  }

  /** Moves behind the end of a string whose first quote has been read. */
  private void skipString() {
    while (at < line.length && line[at] != '"') {
      at += line[at] == '\\' ? 2 : 1;
    }
    at++;
  }

  /** Returns whether the string that has been read is the key of the identity; skips its colon. */
  private boolean isKey(int start) {
    for (int i = 0; i < KEY.length(); i++) {
      if (start + i >= line.length || line[start + i] != KEY.charAt(i)) {
        return false;
      }
    }
    skipBlanks();
    boolean isKey = at < line.length && line[at] == ':';
    at += isKey ? 1 : 0;
    return isKey;
  }

  private void skipBlanks() {
    while (at < line.length && (line[at] == ' ' || line[at] == '\t' || line[at] == '\r')) {
      at++;
    }
  }

  private void readIdentity() {
    skipBlanks();
    int start = at;
    if (at < line.length && line[at] == '"') {
      at++;
      skipString();
    } else {
      while (at < line.length && isOfNumber(line[at])) {
        at++;
      }
    }
    Optional<Object> value = value(start);
    isAmbiguous |= found.isPresent() && !found.equals(value);
    found = value;
  }

  private static boolean isOfNumber(byte c) {
    return c >= '0' && c <= '9' || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
  }

  /** Returns the value that ends here; empty if it is cut off or is no identity. */
  private Optional<Object> value(int start) {
    if (at >= line.length) {
      return Optional.empty();
    }
    try {
      return Message.idOf(Message.parse(Arrays.copyOfRange(line, start, at)));
    } catch (RpcException e) {
      return Optional.empty();
    }
  }
}
