package io.github.lumbre.base;

/** Reports that a command or a measurement failed, with a line that explains why. */
public final class TaskException extends Exception {
  private static final long serialVersionUID = 1;

  private final ExitCode code;

  /**
   * @param message one line that names the invalid file or setting
   */
  public TaskException(ExitCode code, String message) {
    super(message);
    this.code = code;
  }

  /** Creates an exception with its cause. */
  public TaskException(ExitCode code, String message, Throwable cause) {
    super(message, cause);
    this.code = code;
  }

  /** Returns the exit code of the program. */
  public ExitCode code() {
    return code;
  }
}
