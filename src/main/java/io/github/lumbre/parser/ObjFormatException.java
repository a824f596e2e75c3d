package io.github.lumbre.parser;

/** An OBJ file that cannot be read; the message begins with the line. */
final class ObjFormatException extends Exception {
  private static final long serialVersionUID = 1;

  ObjFormatException(int line, String message) {
    super("line " + line + ": " + message);
  }
}
