package io.github.lumbre.cli.output;

import io.github.lumbre.lab.TaskException;

/** How the program's end is told to whoever started it. */
public final class ExitCodes {
  /** Done. */
  public static final int OK = 0;

  /** Warnings, and they were to count as errors. */
  public static final int WARNINGS = 1;

  /** What was to be compared is not the same. */
  public static final int DIFFERENT = 1;

  /** The error that was asked for is not reached. */
  public static final int TARGET = 1;

  /** The command line itself is wrong. */
  public static final int USAGE = 2;

  /** The scene is missing, unreadable or invalid; or a film is, or does not belong to it. */
  public static final int SCENE = 3;

  /** A mesh or picture of the scene cannot be decoded. */
  public static final int ASSET = 4;

  /** Something is larger than a limit or than memory. */
  public static final int LIMIT = 5;

  /** The picture or the film cannot be written. */
  public static final int OUTPUT = 6;

  /** A fault of the program, or samples that are no numbers although strictness was asked for. */
  public static final int INTERNAL = 7;

  /** Stopped by SIGHUP, as when the terminal's window is closed. */
  public static final int HUNG_UP = 129;

  /** Stopped by SIGINT; the virtual machine itself ends with this code. */
  public static final int INTERRUPTED = 130;

  /** Stopped by SIGTERM; the virtual machine itself ends with this code. */
  public static final int TERMINATED = 143;

  private ExitCodes() {}

  /** Returns the code for a task that could not be done. */
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
