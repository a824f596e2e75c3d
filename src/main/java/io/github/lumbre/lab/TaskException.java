package io.github.lumbre.lab;

/** A task of the lab or of the command line that cannot be done, with a line that explains why. */
public final class TaskException extends Exception {
  private static final long serialVersionUID = 1;

  private final Kind kind;

  /** Why a task cannot be done. */
  public enum Kind {
    /** There are warnings, which count as errors. */
    WARNINGS,

    /** The request itself is wrong. */
    USAGE,

    /** The scene is missing, unreadable or invalid; or a film is, or does not belong to it. */
    SCENE,

    /** A mesh or picture of the scene cannot be decoded. */
    ASSET,

    /** Something is larger than a limit or than memory. */
    LIMIT,

    /** A result cannot be written. */
    OUTPUT,

    /** A fault of the program. */
    INTERNAL,

    /** The task was stopped. */
    STOPPED
  }

  /**
   * @param message one line, which names the file or the setting that is wrong
   */
  public TaskException(Kind kind, String message) {
    super(message);
    this.kind = kind;
  }

  /**
   * @param message one line, which names the file or the setting that is wrong
   */
  public TaskException(Kind kind, String message, Throwable cause) {
    super(message, cause);
    this.kind = kind;
  }

  public Kind kind() {
    return kind;
  }
}
