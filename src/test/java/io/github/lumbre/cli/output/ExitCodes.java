package io.github.lumbre.cli.output;

/** The numbers that scripts rely on, stated apart from the program's own. */
public final class ExitCodes {
  public static final int OK = 0;
  public static final int WARNINGS = 1;
  public static final int DIFFERENT = 1;
  public static final int TARGET = 1;
  public static final int USAGE = 2;
  public static final int SCENE = 3;
  public static final int ASSET = 4;
  public static final int LIMIT = 5;
  public static final int OUTPUT = 6;
  public static final int INTERNAL = 7;
  public static final int HUNG_UP = 129;
  public static final int INTERRUPTED = 130;
  public static final int TERMINATED = 143;

  private ExitCodes() {}
}
