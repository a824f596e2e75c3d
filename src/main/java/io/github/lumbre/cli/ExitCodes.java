package io.github.lumbre.cli;

/** How the program's end is told to whoever started it. */
final class ExitCodes {
  /** Done. */
  static final int OK = 0;

  /** Warnings, and they were to count as errors. */
  static final int WARNINGS = 1;

  /** What was to be compared is not the same. */
  static final int DIFFERENT = 1;

  /** The error that was asked for is not reached. */
  static final int TARGET = 1;

  /** The command line itself is wrong. */
  static final int USAGE = 2;

  /** The scene is missing, unreadable or invalid; or a film is, or does not belong to it. */
  static final int SCENE = 3;

  /** A mesh or picture of the scene cannot be decoded. */
  static final int ASSET = 4;

  /** Something is larger than a limit or than memory. */
  static final int LIMIT = 5;

  /** The picture or the film cannot be written. */
  static final int OUTPUT = 6;

  /** A fault of the program, or samples that are no numbers although strictness was asked for. */
  static final int INTERNAL = 7;

  /** Stopped by SIGHUP, as when the terminal's window is closed. */
  static final int HUNG_UP = 129;

  /** Stopped by SIGINT; the virtual machine itself ends with this code. */
  static final int INTERRUPTED = 130;

  /** Stopped by SIGTERM; the virtual machine itself ends with this code. */
  static final int TERMINATED = 143;

  private ExitCodes() {}
}
