package io.github.lumbre.model.format;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.Decimals;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The bytes of a tag of XML, without its brackets. Mutable. */
final class XmlTag {
  /** The most bytes of a tag, and of a text between tags that is read as one. */
  static final int MAX_BYTES = 1 << 20;

  private byte[] bytes = new byte[256];
  private int size;

  /** Removes all bytes. */
  void clear() {
    size = 0;
  }

  /**
   * Adds a byte.
   *
   * @param part in which the tag is, for messages
   * @param line in which the tag begins, for messages
   */
  void add(int c, String part, int line) throws ModelFormatException {
    if (size == bytes.length) {
      if (size == MAX_BYTES) {
        throw Kind.TOO_LARGE.at(
            (part.isEmpty() ? "line " : part + " line ") + line,
            "expected a tag of at most " + MAX_BYTES + " bytes");
      }
      bytes = Arrays.copyOf(bytes, 2 * size);
    }
    bytes[size++] = (byte) c;
  }

  /** Removes the slash at the end of a tag that ends its element; returns whether there is one. */
  boolean dropSlash() {
    boolean hasSlash = size > 0 && bytes[size - 1] == '/';
    size -= hasSlash ? 1 : 0;
    return hasSlash;
  }

  /** Returns whether the tag ends an element that another one began. */
  boolean isEnd() {
    return size > 0 && bytes[0] == '/';
  }

  /** Returns the number of bytes. */
  int size() {
    return size;
  }

  byte at(int offset) {
    return bytes[offset];
  }

  /** Returns a number between two offsets in its simplest form, as {@link Decimals#exact} does. */
  double simpleNumber(int from, int to) {
    return Decimals.exact(bytes, from, to);
  }

  /** Returns the text between two offsets. */
  String string(int from, int to) {
    return new String(bytes, from, to - from, StandardCharsets.UTF_8);
  }

  /** Returns a text with its entities replaced; unknown ones stay. */
  String decoded(int from, int to) {
    return decoded(bytes, from, to);
  }

  /** Returns a text in UTF-8 with its entities replaced; unknown ones stay. */
  static String decoded(byte[] text, int from, int to) {
    return XmlEntities.replaced(new String(text, from, to - from, StandardCharsets.UTF_8));
  }

  /** Returns whether a word follows at an offset. */
  boolean startsWith(int from, String word) {
    for (int i = 0; i < word.length(); i++) {
      if (from + i >= size || bytes[from + i] != word.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /** Returns the offset of the next byte of a value; -1 if there is none before an offset. */
  int indexOf(int c, int from, int to) {
    for (int i = from; i < to; i++) {
      if (bytes[i] == c) {
        return i;
      }
    }
    return -1;
  }

  /** Returns the offset of the next space, or the size. */
  int wordEnd(int from) {
    int i = from;
    while (i < size && !isSpace(bytes[i])) {
      i++;
    }
    return i;
  }

  /** Returns the offset of the next byte that is no space, or the size. */
  int skipSpace(int from) {
    int i = from;
    while (i < size && isSpace(bytes[i])) {
      i++;
    }
    return i;
  }

  static boolean isSpace(byte c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
  }

  /** The entities of XML 1.0 that need no declaration. Stateless. */
  private static final class XmlEntities {
    private static final Pattern ENTITY =
        Pattern.compile("&(?:(amp|lt|gt|quot|apos)|#(\\d{1,7})|#x(\\p{XDigit}{1,6}));");

    private static final Map<String, String> NAMED =
        Map.of("amp", "&", "lt", "<", "gt", ">", "quot", "\"", "apos", "'");

    private XmlEntities() {}

    /** Returns a text with its entities replaced; what is no known entity stays. */
    static String replaced(String text) {
      return text.indexOf('&') < 0
          ? text
          : ENTITY.matcher(text).replaceAll(entity -> Matcher.quoteReplacement(meaning(entity)));
    }

    private static String meaning(MatchResult entity) {
      if (entity.group(1) != null) {
        return NAMED.get(entity.group(1));
      }
      int code =
          entity.group(2) != null
              ? Integer.parseInt(entity.group(2))
              : Integer.parseInt(entity.group(3), 16);
      return Character.isValidCodePoint(code) ? Character.toString(code) : entity.group();
    }
  }
}
