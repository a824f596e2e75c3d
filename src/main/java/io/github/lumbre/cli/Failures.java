package io.github.lumbre.cli;

import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.render.RenderException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;

/** Puts what went wrong into words and an exit code: a line a problem, no stack trace unasked. */
final class Failures implements IExecutionExceptionHandler, IParameterExceptionHandler {
  @Override
  public int handleParseException(ParameterException e, String[] args) {
    CommandLine command = e.getCommandLine();
    String help = command.getCommandSpec().qualifiedName() + " --help";
    new Messages(command.getErr()).error(e.getMessage() + " (see '" + help + "')");
    return ExitCodes.USAGE;
  }

  @Override
  public int handleExecutionException(Exception e, CommandLine command, ParseResult result) {
    return report(e, command, isDebug(result));
  }

  /** Reports anything thrown by a command and returns the exit code. */
  static int report(Throwable thrown, CommandLine command, boolean debug) {
    Messages messages = new Messages(command.getErr());
    int exitCode = describe(thrown, messages, debug);
    if (debug) {
      thrown.printStackTrace(command.getErr());
      command.getErr().flush();
    }
    return exitCode;
  }

  private static int describe(Throwable thrown, Messages messages, boolean debug) {
    if (thrown instanceof CommandException e) {
      messages.error(e.getMessage());
      return e.exitCode();
    }
    if (thrown instanceof SceneFormatException e) {
      e.problems().forEach(messages::line);
      return exitCode(e.kind());
    }
    if (rootIs(thrown, OutOfMemoryError.class)) {
      messages.error(
          "out of memory: the heap is limited to "
              + MemoryEstimate.mebibytes(Runtime.getRuntime().maxMemory())
              + " (LUMBRE_JAVA_OPTS=-Xmx8g raises that)");
      return ExitCodes.LIMIT;
    }
    String advice = debug ? "" : " (--debug shows where)";
    String what = thrown instanceof RenderException ? thrown.getMessage() : thrown.toString();
    messages.error("internal error: " + what + advice);
    return ExitCodes.INTERNAL;
  }

  private static int exitCode(SceneFormatException.Kind kind) {
    return switch (kind) {
      case INVALID -> ExitCodes.SCENE;
      case ASSET -> ExitCodes.ASSET;
      case LIMIT -> ExitCodes.LIMIT;
    };
  }

  private static boolean rootIs(Throwable thrown, Class<? extends Throwable> type) {
    Throwable root = thrown;
    while (root.getCause() != null) {
      root = root.getCause();
    }
    return type.isInstance(root);
  }

  /** Tells whether a command, or the one below it, was asked to show stack traces. */
  static boolean isDebug(ParseResult result) {
    for (ParseResult r = result; r != null; r = r.subcommand()) {
      if (r.hasMatchedOption("--debug")) {
        return true;
      }
    }
    return false;
  }
}
