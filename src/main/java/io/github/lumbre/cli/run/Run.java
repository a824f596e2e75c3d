package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import java.nio.channels.ClosedByInterruptException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * The border of a command: one try around the reading, rendering and writing of a picture. Here
 * alone a cancelled thread becomes an end by a signal or by the time limit, and results and
 * failures become a JSON summary. {@link Failures} knows the exit codes of exceptions.
 *
 * @param summaries printer of JSON summaries; empty if there are none
 * @param frames the sequence that the work renders the next picture of; empty for other work
 */
public record Run(
    Interruption interruption, Optional<Messages> summaries, Optional<Frames> frames) {
  /** Reads, renders and writes a picture, or does a part of this, and returns the exit code. */
  @FunctionalInterface
  public interface Work {
    ExitCode run() throws Exception;
  }

  /** Does work and prints its summary; none if the command line is invalid. */
  public ExitCode of(JsonSummary report, Work work) throws Exception {
    ExitCode code = failing(report, work);
    summarize(report, code.number(), List.of());
    return code;
  }

  /** Does a part of the work, and prints the summary if it fails. */
  public ExitCode failing(JsonSummary report, Work work) throws Exception {
    try {
      ExitCode code = work.run();
      if (frames.isPresent()) {
        frames.get().finish(report.isPartial());
      }
      return code;
    } catch (Exception e) {
      if (Failures.isOfArguments(e)) {
        throw e;
      }
      Exception end = isCancelled(e) ? withoutPicture() : e;
      throw failed(report, frames.isPresent() ? frames.get().end(end) : end);
    } catch (Error e) {
      throw failed(report, e);
    } finally {
      interruption.endRender();
    }
  }

  private static boolean isCancelled(Exception e) {
    return e instanceof CancellationException
        || e instanceof InterruptedException
        || e instanceof ClosedByInterruptException;
  }

  /** Returns the exception for a picture that a signal or the deadline ended without a sample. */
  private Exception withoutPicture() {
    boolean isOutOfTime = !interruption.isRequested();
    return (isOutOfTime ? ExitCode.LIMIT : ExitCode.INTERRUPTED)
        .failure((isOutOfTime ? "--timeout: the time ended" : "stopped") + Failures.NO_PICTURE);
  }

  private <T extends Throwable> T failed(JsonSummary report, T failure) {
    summarize(report, Failures.exitCode(failure).number(), Failures.problems(failure));
    return failure;
  }

  private void summarize(JsonSummary report, int exitCode, List<String> problems) {
    if (summaries.isPresent()) {
      report.put("exit_code", Interruption.exitCode(exitCode));
      if (!problems.isEmpty()) {
        report.put("problems", problems);
      }
      report.print(summaries.get());
    }
  }
}
