package io.github.lumbre.cli.mcp;

/** A call that cannot be done; its message says why, and what to do. */
final class ToolException extends Exception {
  private static final long serialVersionUID = 1;

  ToolException(String message) {
    super(message);
  }

  ToolException(String message, Throwable cause) {
    super(message, cause);
  }
}
