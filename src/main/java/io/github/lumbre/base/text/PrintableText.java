package io.github.lumbre.base.text;

/** Makes texts from files safe to print. Stateless. */
public final class PrintableText {
  private static final int MAX_TEXT = 60;

  /** Longer paths, in characters, are shortened in the middle. */
  private static final int MAX_PATH = 200;

  private PrintableText() {}

  /**
   * Returns a text that is safe to print: quoted, escaped and shortened. A text with double quotes
   * in it gets single quotes.
   */
  public static String quoted(String text) {
    char quote = text.contains("\"") ? '\'' : '"';
    return quote + shortened(text) + quote;
  }

  /** Returns a text that is safe to print: escaped and shortened. */
  public static String shortened(String text) {
    return text.length() <= MAX_TEXT ? escaped(text) : escaped(text.substring(0, MAX_TEXT)) + "…";
  }

  /** Returns a path that is safe to print: escaped, and shortened in the middle. */
  public static String path(String path) {
    String shown = escaped(path);
    if (shown.length() <= MAX_PATH) {
      return shown;
    }
    int end = MAX_PATH / 2;
    return shown.substring(0, end) + "…" + shown.substring(shown.length() - end);
  }

  /** Returns a number in its shortest readable form: 3, 0.25, 1e20. */
  public static String number(double x) {
    return x == Math.rint(x) && Math.abs(x) < 1e15
        ? Long.toString((long) x)
        : Double.toString(x).replace(".0E", "e");
  }

  /** Returns a text with invisible characters written as JSON escapes. */
  public static String escaped(String text) {
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
}
