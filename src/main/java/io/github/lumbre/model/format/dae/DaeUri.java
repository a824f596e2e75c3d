package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.format.MtlMap;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/** The URIs of pictures, as programs write them. Stateless. */
final class DaeUri {
  private static final Pattern DRIVE = Pattern.compile("(?s)/+[A-Za-z]:.*");

  private DaeUri() {}

  /**
   * Returns the name of the file that a URI means: a path with / between names, relative or not.
   * The scheme {@code file} is removed; names of other schemes lead to no file.
   */
  static String fileName(String uri) {
    String name = decoded(uri.strip());
    if (name.regionMatches(true, 0, "file:", 0, 5)) {
      name = name.substring(5);
      name = name.startsWith("//") ? name.substring(2) : name;
      name = name.regionMatches(true, 0, "localhost/", 0, 10) ? name.substring(9) : name;
    }
    return MtlMap.portable(DRIVE.matcher(name).matches() ? name.replaceFirst("^/+", "") : name);
  }

  /** Returns a text with its percent-encoded bytes decoded as UTF-8; what is none stays. */
  static String decoded(String uri) {
    if (uri.indexOf('%') < 0) {
      return uri;
    }
    byte[] text = uri.getBytes(StandardCharsets.UTF_8);
    ByteArrayOutputStream out = new ByteArrayOutputStream(text.length);
    for (int i = 0; i < text.length; i++) {
      int high = text[i] == '%' && i + 2 < text.length ? Character.digit(text[i + 1], 16) : -1;
      int low = high < 0 ? -1 : Character.digit(text[i + 2], 16);
      out.write(low < 0 ? text[i] : 16 * high + low);
      i += low < 0 ? 0 : 2;
    }
    return out.toString(StandardCharsets.UTF_8);
  }
}
