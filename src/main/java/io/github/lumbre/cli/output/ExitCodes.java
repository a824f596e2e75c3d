package io.github.lumbre.cli.output;

import io.github.lumbre.base.TaskException;

/** The exit codes of the program. */
public final class ExitCodes {
  /** Done. */
  public static final int OK = 0;

  /** There are warnings under {@code --strict}. */
  public static final int WARNINGS = 1;

  /** A comparison found a difference. */
  public static final int DIFFERENT = 1;

  /** The target error is not reached. */
  public static final int TARGET = 1;

  /** The command line is invalid. */
  public static final int USAGE = 2;

  /** A scene or checkpoint file is missing, unreadable or invalid, or the two do not match. */
  public static final int SCENE = 3;

  /** A mesh or image of the scene cannot be decoded. */
  public static final int ASSET = 4;

  /** A limit or the available memory is exceeded. */
  public static final int LIMIT = 5;

  /** An output file cannot be written. */
  public static final int OUTPUT = 6;

  /** Internal error, or rejected samples under {@code --strict}. */
  public static final int INTERNAL = 7;

  /** Stopped by SIGHUP, for example when the terminal is closed. */
  public static final int HUNG_UP = 129;

  /** Stopped by SIGINT; the JVM exits with this code on its own. */
  public static final int INTERRUPTED = 130;

  /** Stopped by SIGTERM; the JVM exits with this code on its own. */
  public static final int TERMINATED = 143;

  private ExitCodes() {}

  /** Returns the exit code for a failed task. */
  static int of(TaskException.Kind kind) {
    return switch (kind) {
      case WARNINGS -> WARNINGS;
      case USAGE -> USAGE;
      case SCENE -> SCENE;
      case ASSET -> ASSET;
      case LIMIT -> LIMIT;
      case OUTPUT -> OUTPUT;
      case INTERNAL -> INTERNAL;
      case STOPPED -> INTERRUPTED;
    };
  }
}
