package io.github.lumbre.cli.option;

import io.github.lumbre.cli.option.FlagConverters.ProgressStyle;
import io.github.lumbre.cli.output.JsonProgress;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.ProgressBar;
import io.github.lumbre.cli.output.ProgressDisplay;
import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.RenderJob;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.parser.SceneFormatException;
import java.time.Duration;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The flags that say when a run is to be stopped, and what is told of it meanwhile and after. */
public final class RunFlags {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--timeout",
      paramLabel = "T",
      converter = FlagConverters.OfDuration.class,
      description = {
        "Stop after such a time, reading the scene included: 90s, 5m, 2h.",
        "The picture is what was rendered until then, marked as partial; exit code 5 if that is",
        "nothing."
      })
  private Optional<Duration> timeout;

  @Option(
      names = "--progress",
      paramLabel = "STYLE",
      converter = FlagConverters.OfProgressStyle.class,
      description =
          "How to tell the progress on standard error: bar, none, or json, which is an object on a "
              + "line of its own every second. Default: bar on a terminal, else none.")
  private Optional<ProgressStyle> progress;

  @Option(
      names = "--json",
      description = "Print a summary as a JSON object, on one line of standard output.")
  private boolean json;

  @Option(names = "--quiet", description = "No progress bar, no summary.")
  private boolean quiet;

  @Option(names = "--stats", description = "Tell rays, rates, threads and memory at the end.")
  private boolean stats;

  /** Returns the moment that is a timeout from now. */
  public Deadline deadline() {
    return Deadline.after(timeout);
  }

  /** Tells whether results are for programs. */
  public boolean isJson() {
    return json;
  }

  /** Returns where results go. */
  public Messages out() {
    return new Messages(spec.commandLine().getOut());
  }

  /** Returns where everything else goes. */
  public Messages errors() {
    return new Messages(spec.commandLine().getErr());
  }

  public RenderMonitor monitor(Interruption interruption, Deadline deadline) {
    return new RenderMonitor(interruption, display(), deadline, errors());
  }

  private ProgressDisplay display() {
    ProgressStyle style =
        progress.orElse(
            !quiet && Boolean.getBoolean("lumbre.tty") ? ProgressStyle.BAR : ProgressStyle.NONE);
    return switch (style) {
      case BAR -> ProgressBar.onStandardError();
      case JSON -> new JsonProgress(errors());
      case NONE -> ProgressDisplay.NONE;
    };
  }

  /**
   * Returns what is written and told at the end.
   *
   * @param bits per channel of a PNG
   * @param strict whether samples that are no numbers make an error
   */
  public RenderJob.How how(int bits, boolean strict) {
    return new RenderJob.How(bits, ImageWriter.Options.DEFAULT_JPEG_QUALITY, quiet, stats, strict);
  }

  /** Runs what a command does and returns its exit code, after a summary if one was asked for. */
  public int summarized(JsonSummary report, JsonSummary.Action action)
      throws SceneFormatException, TaskException {
    return json ? report.around(() -> printed(report, action.run()), out()) : action.run();
  }

  private int printed(JsonSummary report, int ofCommand) {
    int exitCode = Interruption.exitCode(ofCommand);
    report.put("exit_code", exitCode);
    report.print(out());
    return exitCode;
  }
}
