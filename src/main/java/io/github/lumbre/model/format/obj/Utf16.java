package io.github.lumbre.model.format.obj;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.Warnings;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/** Recognizes texts in UTF-16 by their byte order marks. Stateless. */
final class Utf16 {
  private Utf16() {}

  /**
   * Returns a text as UTF-8: the same array, unless the text is in UTF-16.
   *
   * @param location of the text, for messages; empty for the model itself
   * @throws ModelFormatException if the texts do not fit into memory
   */
  static byte[] decoded(byte[] text, String location, Limits limits, Warnings warnings)
      throws ModelFormatException {
    if (text.length < 2 || (text[0] & text[1] & 0xff) < 0xfe || text[0] == text[1]) {
      return text;
    }
    // A character of two bytes has at most three in UTF-8.
    ModelLimits.requireMemory(location, 3L * text.length, limits);
    Charset order = text[0] == (byte) 0xfe ? StandardCharsets.UTF_16BE : StandardCharsets.UTF_16LE;
    warnings.add(location, "expected UTF-8, found UTF-16, which is read, too");
    return new String(text, 2, text.length - 2, order).getBytes(StandardCharsets.UTF_8);
  }
}
