package io.github.lumbre.model.format;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The encoding of an XML text, by its byte order mark, its first bytes or its declaration (XML 1.0,
 * appendix F). Stateless.
 */
public final class XmlEncoding {
  /** The part of a text that may hold its declaration. */
  private static final int DECLARATION = 200;

  private static final Pattern ENCODING =
      Pattern.compile("^<\\?xml[^>]*\\sencoding\\s*=\\s*[\"']([A-Za-z][-A-Za-z0-9._]*)[\"']");

  private XmlEncoding() {}

  /**
   * Returns a text as UTF-8: the same array, unless it is in another encoding.
   *
   * @throws ModelFormatException if the texts do not fit into memory
   */
  public static byte[] utf8(byte[] text, Limits limits) throws ModelFormatException {
    Optional<Charset> charset = utf16(text).or(() -> declared(text));
    if (charset.isEmpty() || charset.get().equals(StandardCharsets.UTF_8)) {
      return text;
    }
    // A character has at most three bytes in UTF-8 for each of its own, and two in memory.
    ModelLimits.requireMemory("", 5L * text.length, limits);
    return new String(text, charset.get()).getBytes(StandardCharsets.UTF_8);
  }

  private static Optional<Charset> utf16(byte... text) {
    if (text.length < 2) {
      return Optional.empty();
    }
    return switch ((text[0] & 0xff) << 8 | text[1] & 0xff) {
      case 0xfffe, 0x3c00 -> Optional.of(StandardCharsets.UTF_16LE);
      case 0xfeff, 0x003c -> Optional.of(StandardCharsets.UTF_16BE);
      default -> Optional.empty();
    };
  }

  /** Returns the stated encoding of a text of single bytes; empty if it cannot be that. */
  private static Optional<Charset> declared(byte... text) {
    int length = Math.min(text.length, DECLARATION);
    Matcher matcher = ENCODING.matcher(new String(text, 0, length, StandardCharsets.ISO_8859_1));
    if (!matcher.find()) {
      return Optional.empty();
    }
    String name = matcher.group(1).toUpperCase(Locale.ROOT);
    try {
      // Programs state UTF-16, and then write UTF-8.
      boolean isWide = name.startsWith("UTF-16") || name.startsWith("UTF-32");
      return isWide || name.contains("UCS") || !Charset.isSupported(name)
          ? Optional.empty()
          : Optional.of(Charset.forName(name));
    } catch (IllegalCharsetNameException e) {
      return Optional.empty();
    }
  }

  /** Returns the index of the first byte behind a byte order mark of UTF-8. */
  public static int start(byte... utf8) {
    boolean hasMark =
        utf8.length >= 3
            && utf8[0] == (byte) 0xef
            && utf8[1] == (byte) 0xbb
            && utf8[2] == (byte) 0xbf;
    return hasMark ? 3 : 0;
  }
}
