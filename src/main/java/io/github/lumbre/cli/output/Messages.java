package io.github.lumbre.cli.output;

import io.github.lumbre.scenefile.Problem;
import java.io.PrintWriter;
import java.io.Writer;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Prints messages, one line each. Characters that could move the cursor, color the terminal or fake
 * another line are escaped, as in {@code \\u001b}.
 */
public final class Messages {
  /** Prints nothing. */
  public static final Messages NONE = new Messages(new PrintWriter(Writer.nullWriter()));

  private static final String ERROR = "lumbre: ";
  private static final String WARNING = "warning: ";

  /** The starts of lines that stay in front of a scene's name. */
  private static final List<String> STARTS = List.of(ERROR, WARNING, "hint: ");

  private final PrintWriter out;
  private final List<String> names;
  private final Optional<Set<String>> warned;

  public Messages(PrintWriter out) {
    this(out, List.of());
  }

  /**
   * @param names names of the scene and its files; the first is added to lines that contain none.
   *     If empty, lines are printed as they are
   */
  public Messages(PrintWriter out, List<String> names) {
    this(out, names, Optional.empty());
  }

  private Messages(PrintWriter out, List<String> names, Optional<Set<String>> warned) {
    this.out = out;
    this.names = names;
    this.warned = warned;
  }

  /**
   * Returns a printer of errors and of warnings alone, which prints the first of warnings that
   * differ in numbers alone.
   *
   * @param before texts without numbers of the warnings so far; they are added
   */
  public Messages ofNewWarnings(Set<String> before) {
    return new Messages(out, names, Optional.of(before));
  }

  private boolean isLeftOut(String text) {
    return warned.isPresent()
        && !text.startsWith(ERROR)
        && !(text.startsWith(WARNING) && isNew(text));
  }

  /** Returns whether no warning before differs from a text in numbers alone. */
  private boolean isNew(String text) {
    return warned.isEmpty() || warned.get().add(text.replaceAll("[0-9]+", ""));
  }

  private String named(String text) {
    if (names.isEmpty() || names.stream().anyMatch(text::contains)) {
      return text;
    }
    String start = STARTS.stream().filter(text::startsWith).findFirst().orElse("");
    return start + names.get(0) + ": " + text.substring(start.length());
  }

  public void line(String text) {
    if (!isLeftOut(text)) {
      print(text);
    }
  }

  /** Prints a line about what a picture lacks, if a warning would be printed. */
  public void note(String text) {
    if (isNew(text)) {
      print(text);
    }
  }

  private void print(String text) {
    ProgressBar.aside(
        () -> {
          out.println(printable(named(text)));
          out.flush();
        });
  }

  /** Prints a line that begins with the program's name. */
  public void error(String text) {
    line(ERROR + text);
  }

  /** Prints a line for each warning. */
  public void warnings(List<Problem> warnings) {
    warnings.forEach(warning -> warning(ProblemText.of(warning)));
  }

  /** Prints a line that begins with {@code warning:}. */
  public void warning(String text) {
    line(WARNING + text);
  }

  /** Returns a text with its control and formatting characters written as escapes. */
  public static String printable(String text) {
    StringBuilder safe = new StringBuilder(text.length());
    text.codePoints()
        .forEach(
            c -> {
              if (isSafe(c)) {
                safe.appendCodePoint(c);
              } else {
                for (char unit : Character.toChars(c)) {
                  safe.append(String.format(Locale.ROOT, "\\u%04x", (int) unit));
                }
              }
            });
    return safe.toString();
  }

  private static boolean isSafe(int codePoint) {
    return switch (Character.getType(codePoint)) {
      case Character.CONTROL,
          Character.FORMAT,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR,
          Character.SURROGATE,
          Character.UNASSIGNED ->
          false;
      default -> true;
    };
  }
}
