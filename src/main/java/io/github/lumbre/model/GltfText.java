package io.github.lumbre.model;

import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/** Writes texts and numbers of a glTF file into messages. */
final class GltfText {
  private static final int MAX_TEXT = 60;
  private static final int MAX_PATH = 200;
  private static final int MAX_CHOICES = 20;

  private GltfText() {}

  /** Returns a text that is safe to print: quoted, escaped and shortened. */
  static String quoted(String text) {
    return '"' + shortened(text) + '"';
  }

  /** Returns a text that is safe to print: escaped and shortened. */
  static String shortened(String text) {
    return text.length() <= MAX_TEXT ? escaped(text) : escaped(text.substring(0, MAX_TEXT)) + "…";
  }

  /** Returns a path that is safe to print: escaped, and shortened in the middle. */
  static String path(String path) {
    String shown = escaped(path);
    if (shown.length() <= MAX_PATH) {
      return shown;
    }
    int end = MAX_PATH / 2;
    return shown.substring(0, end) + "…" + shown.substring(shown.length() - end);
  }

  private static String escaped(String text) {
    StringBuilder out = new StringBuilder(text.length());
    text.codePoints().forEach(c -> append(out, c));
    return out.toString();
  }

  private static void append(StringBuilder out, int codePoint) {
    switch (Character.getType(codePoint)) {
      case Character.CONTROL,
              Character.FORMAT,
              Character.SURROGATE,
              Character.LINE_SEPARATOR,
              Character.PARAGRAPH_SEPARATOR,
              Character.PRIVATE_USE,
              Character.UNASSIGNED ->
          out.append(String.format("\\u%04x", codePoint));
      default -> out.appendCodePoint(codePoint);
    }
  }

  /** Returns a number without a fraction if it is whole. */
  static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }

  /** Returns names to choose from, such as {@code "a", "b" or "c"}. */
  static String choice(Collection<String> names) {
    List<String> shown =
        names.stream().limit(MAX_CHOICES).map(GltfText::quoted).collect(Collectors.toList());
    if (names.size() > MAX_CHOICES) {
      shown.add("another name");
    }
    int last = shown.size() - 1;
    return last == 0
        ? shown.get(0)
        : String.join(", ", shown.subList(0, last)) + " or " + shown.get(last);
  }
}
