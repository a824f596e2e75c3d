package io.github.lumbre.cli.output;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.RenderException;
import io.github.lumbre.render.checkpoint.FilmFormatException;
import io.github.lumbre.render.checkpoint.FilmMismatchException;
import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.Closeable;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * Reports failures: one line per problem, an exit code, and a stack trace only under {@code
 * --debug}.
 *
 * @param commands names of all commands
 * @param program the program with all commands
 */
public record Failures(Set<String> commands, Supplier<CommandLine> program)
    implements IExecutionExceptionHandler, IParameterExceptionHandler {
  /** The end of the sentence about a picture that has no sample. */
  public static final String NO_PICTURE = " before anything was rendered; no picture is written";

  @Override
  public int handleParseException(ParameterException e, String[] args) {
    CommandLine command = e.getCommandLine();
    String help = command.getCommandSpec().qualifiedName() + " --help";
    new Messages(command.getErr()).error(message(e) + " (see '" + help + "')");
    return ExitCode.USAGE.number();
  }

  private String message(ParameterException e) {
    Optional<String> unmatched = unmatched(e).stream().findFirst();
    CommandSpec command = e.getCommandLine().getCommandSpec();
    if (unmatched.isPresent() && unmatched.get().startsWith("-")) {
      return unknownOption(unmatched.get(), command);
    }
    if (unmatched.isPresent() && command.parent() == null) {
      String found = unmatched.get();
      return "unknown command " + found + suggestions().forCommand(found);
    }
    // Some messages of picocli begin with "Error: " or end with a period.
    return e.getMessage().replaceFirst("^Error: ", "").replaceFirst("[.]$", "");
  }

  /** Returns the arguments that are neither options nor parameters of the command. */
  private static List<String> unmatched(ParameterException e) {
    if (e instanceof UnmatchedArgumentException unmatched) {
      return unmatched.getUnmatched();
    }
    // picocli reports missing parameters first, although an unknown option is often their cause.
    return e instanceof MissingParameterException
        ? e.getCommandLine().getUnmatchedArguments()
        : List.of();
  }

  private String unknownOption(String found, CommandSpec command) {
    String unknown = "unknown option '" + found + "'";
    // No option contains a dot.
    return !found.startsWith("--") && found.contains(".")
        ? unknown + "; a file of this name is written ./" + found + ", or after --"
        : unknown + suggestions().forFlag(found, command);
  }

  private Suggestions suggestions() {
    return new Suggestions(commands, program);
  }

  @Override
  public int handleExecutionException(Exception e, CommandLine command, ParseResult result) {
    return report(e, command, isDebug(result)).number();
  }

  /** Reports an exception or error thrown by a command, and returns the exit code. */
  public static ExitCode report(Throwable thrown, CommandLine command, boolean debug) {
    return report(thrown, command.getErr(), debug, new Messages(command.getErr()));
  }

  /** Reports an exception or error of one of several scenes, and returns the exit code. */
  public static ExitCode report(Throwable thrown, CommandLine command, Messages messages) {
    return report(
        thrown, command.getErr(), isDebug(command.getParent().getParseResult()), messages);
  }

  private static ExitCode report(
      Throwable thrown, PrintWriter err, boolean debug, Messages messages) {
    if (thrown instanceof SceneFormatException) {
      problems(thrown).forEach(messages::line);
    } else {
      boolean unexplained = exitCode(thrown) == ExitCode.INTERNAL && !debug;
      String advice = unexplained ? " (--debug prints the stack trace)" : "";
      problems(thrown).forEach(problem -> messages.error(problem + advice));
    }
    if (debug) {
      thrown.printStackTrace(err);
      err.flush();
    }
    return exitCode(thrown);
  }

  @FunctionalInterface
  public interface Writing<T> {
    T run() throws IOException;
  }

  /**
   * Returns the result of opening or writing output files, whose exceptions name the file.
   *
   * @throws TaskException if that fails
   */
  public static <T> T written(Writing<T> action) throws TaskException {
    try {
      return action.run();
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(e.getMessage(), e);
    }
  }

  /** Closes a file, if there is one. */
  public static void close(Optional<? extends Closeable> file) {
    try {
      if (file.isPresent()) {
        file.get().close();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the failure to read a model. */
  public static TaskException ofModel(Path file, ModelFormatException e) {
    ExitCode code =
        switch (e.kind()) {
          case TOO_LARGE -> ExitCode.LIMIT;
          case ASSET -> ExitCode.ASSET;
          case MALFORMED, UNSUPPORTED -> ExitCode.SCENE;
        };
    Problem problem = new Problem(file.toString(), e.location(), e.detail());
    return code.failure(ProblemText.of(problem), e);
  }

  /** Returns the failure to read a checkpoint file. */
  public static TaskException ofFilm(Path file, IOException e) {
    String reason =
        e instanceof NoSuchFileException
            ? "does not exist"
            : e instanceof FilmFormatException
                ? e.getMessage()
                : "cannot be read: " + FileFailure.reason(e);
    return ExitCode.SCENE.failure(file + ": " + reason, e);
  }

  /** Returns whether the command line is invalid, so that there is nothing to summarize. */
  public static boolean isOfArguments(Exception e) {
    return e instanceof ParameterException;
  }

  /** Returns the exit code for an exception or error. */
  public static ExitCode exitCode(Throwable thrown) {
    if (thrown instanceof TaskException e) {
      return e.code();
    }
    if (thrown instanceof SceneFormatException e) {
      return switch (e.kind()) {
        case INVALID -> ExitCode.SCENE;
        case ASSET -> ExitCode.ASSET;
        case LIMIT -> ExitCode.LIMIT;
        case OPTION -> ExitCode.USAGE;
      };
    }
    if (thrown instanceof InvalidPathException || thrown instanceof ParameterException) {
      return ExitCode.USAGE;
    }
    if (thrown instanceof CancellationException || thrown instanceof InterruptedException) {
      return ExitCode.INTERRUPTED;
    }
    if (thrown instanceof IOException || thrown instanceof FilmMismatchException) {
      return ExitCode.SCENE;
    }
    return rootIs(thrown, OutOfMemoryError.class) ? ExitCode.LIMIT : ExitCode.INTERNAL;
  }

  /**
   * Returns the problems that an exception or error reports, at least one line; none if a signal
   * ended work whose results so far are printed.
   */
  public static List<String> problems(Throwable thrown) {
    if (thrown instanceof TaskException
        || thrown instanceof FilmMismatchException
        || thrown instanceof ParameterException) {
      return List.of(thrown.getMessage());
    }
    if (thrown instanceof SceneFormatException e) {
      return ProblemText.of(e);
    }
    if (thrown instanceof InvalidPathException e) {
      return List.of(e.getInput() + ": " + FileFailure.reason(e));
    }
    if (thrown instanceof CancellationException) {
      return List.of("stopped" + NO_PICTURE);
    }
    if (thrown instanceof InterruptedException) {
      return List.of();
    }
    if (thrown instanceof IOException e) {
      String file = e instanceof FileSystemException named ? named.getFile() : "a file";
      return List.of(file + ": cannot be read: " + FileFailure.reason(e));
    }
    if (rootIs(thrown, OutOfMemoryError.class)) {
      // How much is missing is not known.
      long heap = Runtime.getRuntime().maxMemory();
      return List.of(
          "out of memory: the maximum heap size is %s; %s"
              .formatted(MemoryEstimate.mebibytes(heap), MemoryCheck.advice(2 * heap)));
    }
    String what = thrown instanceof RenderException ? thrown.getMessage() : thrown.toString();
    // Further lines are details, which --debug prints.
    return List.of("internal error: " + what.lines().findFirst().orElse(what));
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
