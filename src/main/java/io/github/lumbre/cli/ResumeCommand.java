package io.github.lumbre.cli;

import io.github.lumbre.checkpoint.CheckpointFile;
import io.github.lumbre.checkpoint.FilmFile;
import io.github.lumbre.checkpoint.FilmHeader;
import io.github.lumbre.checkpoint.FilmMismatchException;
import io.github.lumbre.checkpoint.FilmPart;
import io.github.lumbre.image.OutputFile;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code lumbre resume}: goes on with a render that was stopped, or adds samples to one. */
@Command(
    name = "resume",
    header = "Go on with a render from its checkpoint.",
    description =
        "The picture is the same, bit for bit, as that of a render that was never stopped. The"
            + " scene and its files must be as they were.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    usageHelpWidth = 100,
    sortOptions = false,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre render scene.json -s 4000 --checkpoint night.film",
      "  lumbre resume night.film",
      "  lumbre resume night.film -s 8000"
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done, or stopped by --timeout with a partial picture",
      "2:The command line is wrong",
      "3:The film is damaged or of another scene, or the scene cannot be used",
      "4:A mesh or picture of the scene cannot be decoded",
      "5:Something is larger than a limit or than memory",
      "6:The picture or the film cannot be written",
      "7:A fault of the program",
      "130, 143:Stopped by SIGINT (Ctrl-C), SIGTERM; film and picture are saved"
    })
final class ResumeCommand implements Callable<Integer> {
  @Parameters(paramLabel = "FILM", description = "What 'lumbre render --checkpoint' wrote.")
  private Path film;

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      description = "Samples per pixel, those that the film has included (as before).")
  private Optional<Integer> samples;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT",
      description = "The picture (as before).")
  private Optional<Path> output;

  @Option(
      names = "--scene",
      paramLabel = "SCENE",
      description = "Where the scene is now, if it was moved.")
  private Optional<Path> scene;

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Threads; 0 means one per processor.")
  private Optional<Integer> threads;

  @Option(
      names = "--bucket",
      paramLabel = "N",
      description = "Side of the squares that threads render (32).")
  private Optional<Integer> bucket;

  @Mixin private KernelFlag kernel;

  @Option(
      names = "--timeout",
      paramLabel = "T",
      converter = FlagConverters.OfDuration.class,
      description = "Stop after such a time: 90s, 5m, 2h.")
  private Optional<Duration> timeout;

  @Mixin private CheckpointFlags checkpoints;

  @Option(names = "--quiet", description = "No progress bar, no summary.")
  private boolean quiet;

  @Option(names = "--stats", description = "Tell rays, rates, threads and memory at the end.")
  private boolean stats;

  @Option(names = "--debug", description = "Show the stack trace of an error.")
  private boolean debug;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws CommandException, SceneFormatException {
    samples.ifPresent(n -> require("--samples", 1, RenderSettings.MAX_SAMPLES, n));
    threads.ifPresent(n -> require("--threads", 0, RenderSettings.MAX_THREADS, n));
    bucket.ifPresent(n -> require("--bucket", 1, Integer.MAX_VALUE, n));
    checkpoints.validate();
    kernel.apply();
    Deadline deadline = Deadline.after(timeout);
    Messages messages = new Messages(spec.commandLine().getErr());
    if (!Files.exists(film) && !Files.exists(OutputFile.previous(film))) {
      throw new CommandException(ExitCodes.SCENE, film + ": does not exist");
    }
    try (FilmKeeper keeper = checkpoints.keeper(film, messages)) {
      CheckpointFile.Loaded loaded = FilmInput.load(film, messages);
      FilmNotes notes = new FilmNotes(film, loaded.file().header());
      Path target = output.isPresent() ? output.get() : notes.output();
      try (PictureOutput picture = PictureOutput.reserve(target, checkpoints.fallback());
          Interruption interruption = Interruption.listen(picture::close, keeper::close)) {
        RenderMonitor monitor =
            new RenderMonitor(
                interruption,
                !quiet && Boolean.getBoolean("lumbre.tty")
                    ? ProgressDisplay::bar
                    : total -> ProgressDisplay.NONE,
                deadline,
                messages);
        return resume(loaded, notes, picture, keeper, monitor, interruption, messages);
      }
    }
  }

  private void require(String flag, int low, int high, int found) {
    if (found < low || found > high) {
      throw new ParameterException(
          spec.commandLine(), flag + ": expected " + low + " to " + high + ", found " + found);
    }
  }

  private int resume(
      CheckpointFile.Loaded loaded,
      FilmNotes notes,
      PictureOutput picture,
      FilmKeeper keeper,
      RenderMonitor monitor,
      Interruption interruption,
      Messages messages)
      throws CommandException, SceneFormatException {
    FilmFile content = loaded.file();
    requireOnePart(content.header());
    Path path = scene.isPresent() ? scene.get() : notes.scene();
    SceneFile file = parse(notes, path, messages);
    Map<String, String> identity = FilmHeader.identity(file.hash(), file.settings());
    try {
      content.header().requireSame(identity, film.toString(), path.toString());
    } catch (FilmMismatchException e) {
      throw new CommandException(ExitCodes.SCENE, e.getMessage(), e);
    }
    int most = content.header().parts().get(0).most();
    if (file.settings().samples() < most) {
      throw new CommandException(
          ExitCodes.USAGE, "--samples: the film has " + most + " samples per pixel already");
    }
    MemoryEstimate.require(file.settings());
    if (!interruption.beginRender()) {
      return ExitCodes.INTERRUPTED;
    }
    setDamagedAside(loaded, messages);
    keeper.begin(
        identity,
        FilmNotes.of(path, file, picture.target(), notes.bits(), notes.lenient()),
        file.settings());
    RenderJob.How how = new RenderJob.How(notes.bits(), quiet, stats, false);
    JsonSummary report = new JsonSummary("resume", path);
    return new RenderJob(
            path,
            file,
            picture,
            keeper,
            monitor,
            messages,
            report,
            RunBudget.ofSamples(file.settings().samples()),
            how)
        .run(content.film());
  }

  private void requireOnePart(FilmHeader header) throws CommandException {
    List<FilmPart> parts = header.parts();
    if (parts.size() != 1 || !parts.get(0).window().equals(header.window())) {
      throw new CommandException(
          ExitCodes.SCENE,
          film + ": its samples have gaps, so it cannot be gone on with: " + parts);
    }
  }

  private SceneFile parse(FilmNotes notes, Path path, Messages messages)
      throws CommandException, SceneFormatException {
    SceneParser parser = notes.parser(this::override);
    SceneFile file;
    try {
      file = parser.parse(path);
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.SCENE, path + ": the film's scene cannot be read: " + e.getMessage(), e);
    }
    messages.warnings(file.warnings());
    return file;
  }

  private void override(RenderSettings.Builder builder) {
    samples.ifPresent(builder::samples);
    threads.ifPresent(builder::threads);
    bucket.ifPresent(builder::bucketSize);
  }

  /** Gives a damaged film another name, lest the next save puts it in place of the good one. */
  private void setDamagedAside(CheckpointFile.Loaded loaded, Messages messages)
      throws CommandException {
    if (loaded.problem().isEmpty() || !Files.exists(film)) {
      return;
    }
    Path aside = film.resolveSibling(film.getFileName() + ".damaged");
    try {
      Files.move(film, aside, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.OUTPUT, film + ": cannot be renamed to " + aside + ": " + e.getMessage(), e);
    }
    messages.line("warning: " + film + ": is kept as " + aside);
  }
}
