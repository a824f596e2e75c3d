package io.github.lumbre.base;

/** Reports that a command or a measurement failed, with a line that explains why. */
public final class TaskException extends Exception {
  private static final long serialVersionUID = 1;

  private final Kind kind;

  /** The reason for the failure. */
  public enum Kind {
    /** There are warnings, and they are treated as errors. */
    WARNINGS,

    /** The request is invalid. */
    USAGE,

    /** A scene or checkpoint file is missing, unreadable or invalid, or the two do not match. */
    SCENE,

    /** A mesh or image of the scene cannot be decoded. */
    ASSET,

    /** A limit or the available memory is exceeded. */
    LIMIT,

    /** A result cannot be written. */
    OUTPUT,

    /** Internal error. */
    INTERNAL,

    /** The task was stopped. */
    STOPPED;

    /** Returns an exception for this reason; see {@link TaskException}. */
    public TaskException failure(String message) {
      return new TaskException(this, message);
    }

    /** Returns an exception for this reason, with its cause. */
    public TaskException failure(String message, Throwable cause) {
      return new TaskException(this, message, cause);
    }
  }

  /**
   * @param message one line that names the invalid file or setting
   */
  public TaskException(Kind kind, String message) {
    super(message);
    this.kind = kind;
  }

  /** Creates an exception with its cause. */
  public TaskException(Kind kind, String message, Throwable cause) {
    super(message, cause);
    this.kind = kind;
  }

  public Kind kind() {
    return kind;
  }
}
