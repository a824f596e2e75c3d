package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.regex.Pattern;

/** Decodes the URIs of a glTF file: data URIs (RFC 2397) and relative paths (RFC 3986). */
final class GltfUri {
  private static final Pattern SCHEME = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:.*|//.*");

  private GltfUri() {}

  /** Returns whether a URI contains the data itself. */
  static boolean isData(String uri) {
    return uri.regionMatches(true, 0, "data:", 0, 5);
  }

  /**
   * Returns the data in a data URI.
   *
   * @throws ModelFormatException if it has no data, or its encoding is damaged
   */
  static byte[] data(String uri, String location) throws ModelFormatException {
    int comma = uri.indexOf(',');
    if (comma < 0) {
      throw damaged(location, "expected a comma in a data URI, found none");
    }
    if (!uri.substring(0, comma).endsWith(";base64")) {
      return unescaped(uri.substring(comma + 1), location);
    }
    byte[] text = uri.substring(comma + 1).getBytes(StandardCharsets.ISO_8859_1);
    try {
      return Base64.getDecoder().decode(text);
    } catch (IllegalArgumentException e) {
      throw damaged(location, "expected base64, found other characters");
    }
  }

  /**
   * Returns the name of a file.
   *
   * @throws ModelFormatException if the URI is not relative, or its encoding is damaged
   */
  static String fileName(String uri, String location) throws ModelFormatException {
    if (SCHEME.matcher(uri).matches()) {
      throw damaged(
          location, "expected a relative path or a data URI, found " + PrintableText.quoted(uri));
    }
    try {
      return StandardCharsets.UTF_8
          .newDecoder()
          .decode(ByteBuffer.wrap(unescaped(uri, location)))
          .toString();
    } catch (CharacterCodingException e) {
      throw damaged(location, "expected UTF-8, found " + PrintableText.quoted(uri));
    }
  }

  private static byte[] unescaped(String uri, String location) throws ModelFormatException {
    byte[] text = uri.getBytes(StandardCharsets.UTF_8);
    ByteArrayOutputStream out = new ByteArrayOutputStream(text.length);
    for (int i = 0; i < text.length; i++) {
      if (text[i] != '%') {
        out.write(text[i]);
        continue;
      }
      int high = i + 2 <= text.length - 1 ? Character.digit(text[i + 1], 16) : -1;
      int low = i + 2 <= text.length - 1 ? Character.digit(text[i + 2], 16) : -1;
      if (high < 0 || low < 0) {
        throw damaged(
            location,
            "expected two hexadecimal digits after %, found " + PrintableText.quoted(uri));
      }
      out.write(16 * high + low);
      i += 2;
    }
    return out.toByteArray();
  }

  private static ModelFormatException damaged(String location, String message) {
    return Kind.ASSET.at(location, message);
  }
}
