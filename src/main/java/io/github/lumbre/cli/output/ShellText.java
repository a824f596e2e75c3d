package io.github.lumbre.cli.output;

/** Words of command lines for a POSIX shell. Stateless. */
public final class ShellText {
  private ShellText() {}

  /** Returns a word, quoted if necessary. */
  public static String quoted(String word) {
    return word.matches("[A-Za-z0-9_./\\\\:=,+%@-]+")
        ? word
        : "'" + word.replace("'", "'\\''") + "'";
  }
}
