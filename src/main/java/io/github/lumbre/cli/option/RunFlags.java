package io.github.lumbre.cli.option;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.FlagConverters.ProgressStyle;
import io.github.lumbre.cli.output.JsonProgress;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.ProgressBar;
import io.github.lumbre.cli.output.ProgressDisplay;
import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.PictureExposure;
import io.github.lumbre.cli.run.RenderJob;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.run.Run;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The flags for a run's timeout and its reports. */
@Command(optionListHeading = Headings.EXECUTION)
public final class RunFlags extends Flags {
  @Option(
      names = "--timeout",
      paramLabel = "DURATION",
      description =
          "Stop after this time, loading included: 90s, 5m, 2h. The unfinished picture is written"
              + " and marked as partial; exit code 5 if a picture was not begun.")
  private Optional<Duration> timeout;

  @Option(
      names = "--progress",
      paramLabel = "STYLE",
      description =
          "Show progress on standard error: bar, none or json (one JSON object per second and"
              + " line). Default: bar on a terminal, else none.")
  private Optional<ProgressStyle> progress;

  @Option(names = "--json", description = "Print a summary as one line of JSON.")
  private boolean json;

  @Option(names = "--quiet", description = "Print no progress bar, no summary and no hint.")
  private boolean quiet;

  @Option(
      names = "--stats",
      description = "Print ray counts, throughput, threads and memory at the end.")
  private boolean stats;

  private String title = "";
  private List<String> names = List.of();
  private boolean isBrief;
  private Map<String, Object> place = Map.of();
  private final Set<String> warned = new HashSet<>();
  private boolean hasHinted;

  /** Names the current one of several scenes in its messages and on its progress bar. */
  public void about(Frames frames, Path scene) {
    Path picture = frames.target().getFileName();
    title = frames.title();
    place = new LinkedHashMap<>(frames.placeValues());
    place.put("scene", scene.toString());
    names = List.of(scene.toString(), String.valueOf(scene.getFileName()), picture.toString());
  }

  /**
   * Names the current one of the frames of a sequence in its messages, which are warnings alone
   * unless statistics are wanted, each kind once.
   */
  public void about(Frames frames) {
    title = frames.place();
    place = new LinkedHashMap<>(frames.placeValues());
    names = List.of(String.valueOf(frames.target().getFileName()));
    isBrief = !stats;
  }

  /** Ends the naming of one of several scenes or frames. */
  public void aboutAll() {
    title = "";
    place = Map.of();
    names = List.of();
    isBrief = false;
  }

  /** Prints the summary of several pictures, unless there shall be none. */
  public void summarize(String summary, Duration time) {
    if (!quiet) {
      aboutAll();
      errors().line(String.format(Locale.ROOT, "%s; %.2f s", summary, 1e-9 * time.toNanos()));
    }
  }

  /**
   * Prints a hint about what a flag would mend, if there is one: the first of the command alone,
   * and none beside JSON or under {@code --quiet}.
   */
  public void hint(Supplier<Optional<String>> finder) {
    if (!quiet && !json && !hasHinted) {
      Optional<String> hint = finder.get();
      hint.ifPresent(text -> errors().line("hint: " + text));
      hasHinted = hint.isPresent();
    }
  }

  /** {@linkplain SceneOptions#announce Announces} a scene, except under {@code --quiet}. */
  public void announce(SceneOptions scene) throws TaskException {
    if (!quiet) {
      scene.announce(errors());
    }
  }

  /** Returns the deadline that the timeout sets, counted from now. */
  public Deadline deadline() {
    return Deadline.after(timeout);
  }

  /** Returns whether the results are printed as JSON. */
  public boolean isJson() {
    return json;
  }

  /** Returns the printer of results, standard output. */
  public Messages out() {
    return new Messages(spec.commandLine().getOut());
  }

  /** Returns the printer of everything else, standard error. */
  public Messages errors() {
    Messages all = new Messages(spec.commandLine().getErr(), names);
    return isBrief ? all.ofNewWarnings(warned) : all;
  }

  public RenderMonitor monitor(Interruption interruption, Deadline deadline) {
    return new RenderMonitor(interruption, display(), deadline, errors());
  }

  private ProgressDisplay display() {
    ProgressStyle style =
        progress.orElse(
            !quiet && Boolean.getBoolean("lumbre.tty") ? ProgressStyle.BAR : ProgressStyle.NONE);
    return switch (style) {
      case BAR -> ProgressBar.onStandardError(title);
      case JSON -> new JsonProgress(new Messages(spec.commandLine().getErr()), place);
      case NONE -> ProgressDisplay.NONE;
    };
  }

  /** Returns {@linkplain RenderJob.Options the options of the picture and the summary}. */
  public RenderJob.Options jobOptions(
      int bits,
      int jpegQuality,
      boolean strict,
      Optional<Denoising> denoising,
      Set<Layer> layers,
      PictureExposure exposing,
      Consumer<DisplayLight> receiver) {
    return new RenderJob.Options(
        bits,
        jpegQuality,
        quiet,
        stats,
        strict,
        denoising,
        layers,
        exposing,
        receiver,
        this::hint,
        true,
        Optional.empty());
  }

  /** Returns the border of the command, which prints a summary under {@code --json}. */
  public Run border(Interruption interruption, Optional<Frames> frames) {
    return new Run(interruption, json ? Optional.of(out()) : Optional.empty(), frames);
  }
}
