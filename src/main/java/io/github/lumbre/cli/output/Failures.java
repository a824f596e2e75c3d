package io.github.lumbre.cli.output;

import io.github.lumbre.file.FileFailure;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.parser.Problem;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.RenderException;
import java.nio.file.InvalidPathException;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;

/**
 * Reports failures: one line per problem, an exit code, and a stack trace only under {@code
 * --debug}.
 */
public final class Failures implements IExecutionExceptionHandler, IParameterExceptionHandler {
  @Override
  public int handleParseException(ParameterException e, String[] args) {
    CommandLine command = e.getCommandLine();
    String help = command.getCommandSpec().qualifiedName() + " --help";
    // Some messages of picocli begin with "Error: " or end with a period.
    String message = e.getMessage().replaceFirst("^Error: ", "").replaceFirst("[.]$", "");
    new Messages(command.getErr()).error(message + " (see '" + help + "')");
    return ExitCodes.USAGE;
  }

  @Override
  public int handleExecutionException(Exception e, CommandLine command, ParseResult result) {
    return report(e, command, isDebug(result));
  }

  /** Reports an exception or error thrown by a command, and returns the exit code. */
  public static int report(Throwable thrown, CommandLine command, boolean debug) {
    Messages messages = new Messages(command.getErr());
    if (thrown instanceof SceneFormatException) {
      problems(thrown).forEach(messages::line);
    } else {
      boolean unexplained = exitCode(thrown) == ExitCodes.INTERNAL && !debug;
      String advice = unexplained ? " (--debug prints the stack trace)" : "";
      problems(thrown).forEach(problem -> messages.error(problem + advice));
    }
    if (debug) {
      thrown.printStackTrace(command.getErr());
      command.getErr().flush();
    }
    return exitCode(thrown);
  }

  /** Returns the exit code for an exception or error. */
  static int exitCode(Throwable thrown) {
    if (thrown instanceof TaskException e) {
      return ExitCodes.of(e.kind());
    }
    if (thrown instanceof SceneFormatException e) {
      return switch (e.kind()) {
        case INVALID -> ExitCodes.SCENE;
        case ASSET -> ExitCodes.ASSET;
        case LIMIT -> ExitCodes.LIMIT;
      };
    }
    if (thrown instanceof InvalidPathException) {
      return ExitCodes.USAGE;
    }
    return rootIs(thrown, OutOfMemoryError.class) ? ExitCodes.LIMIT : ExitCodes.INTERNAL;
  }

  /** Returns the problems that an exception or error reports, at least one line. */
  static List<String> problems(Throwable thrown) {
    if (thrown instanceof TaskException e) {
      return List.of(e.getMessage());
    }
    if (thrown instanceof SceneFormatException e) {
      return e.problems().stream().map(Problem::toString).toList();
    }
    if (thrown instanceof InvalidPathException e) {
      return List.of(e.getInput() + ": " + FileFailure.reason(e));
    }
    if (rootIs(thrown, OutOfMemoryError.class)) {
      return List.of(
          "out of memory: the maximum heap size is "
              + MemoryEstimate.mebibytes(Runtime.getRuntime().maxMemory())
              + "; raise it with LUMBRE_JAVA_OPTS=-Xmx8g");
    }
    String what = thrown instanceof RenderException ? thrown.getMessage() : thrown.toString();
    return List.of("internal error: " + what);
  }

  private static boolean rootIs(Throwable thrown, Class<? extends Throwable> type) {
    Throwable root = thrown;
    while (root.getCause() != null) {
      root = root.getCause();
    }
    return type.isInstance(root);
  }

  /** Returns whether a command or its subcommand was given {@code --debug}. */
  public static boolean isDebug(ParseResult result) {
    for (ParseResult r = result; r != null; r = r.subcommand()) {
      if (r.hasMatchedOption("--debug")) {
        return true;
      }
    }
    return false;
  }
}
