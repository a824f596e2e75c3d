package io.github.lumbre.parser;

/** An OBJ file that cannot be read, or is too large; the message begins with the line. */
final class ObjFormatException extends Exception {
  private static final long serialVersionUID = 1;

  private final boolean tooLarge;

  ObjFormatException(int line, String message) {
    this(line, message, false);
  }

  ObjFormatException(int line, String message, boolean tooLarge) {
    super("line " + line + ": " + message);
    this.tooLarge = tooLarge;
  }

  /** Returns whether the file may be sound but is larger than a limit. */
  boolean isTooLarge() {
    return tooLarge;
  }
}
