package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.cli.option.DevelopFlags;
import io.github.lumbre.cli.option.FlagChecks;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.run.FilmInput;
import io.github.lumbre.cli.run.FilmNotes;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.FilmMerge;
import io.github.lumbre.render.checkpoint.FilmMismatchException;
import io.github.lumbre.render.checkpoint.FilmPart;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre merge}: merges checkpoint files of one picture. */
@Command(
    name = "merge",
    header = "Merge checkpoint files that were rendered separately.",
    description =
        "Merge files with different samples (render --samples-from, --samples-to) or different"
            + " parts of the frame (render --crop). The result is bit-identical to a single render."
            + " Files that share a sample, or come from different scenes or settings, are"
            + " rejected. An existing checkpoint file is replaced only by one that has all of its"
            + " samples, unless --overwrite is given.",
    modelTransformer = SettingFlags.Adder.class,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre render scene.json --samples-to 500 --checkpoint a.film",
      "  lumbre render scene.json --samples-from 500 --samples-to 1000 --checkpoint b.film",
      "  lumbre merge a.film b.film -o all.film",
      "  lumbre merge a.film b.film -o all.png"
    })
@Exits({ExitCode.OK, ExitCode.FILM, ExitCode.LIMIT, ExitCode.OUTPUT})
final class MergeCommand extends Subcommand {
  @Parameters(
      paramLabel = "FILM",
      arity = "1..*",
      description = "Checkpoint file from 'lumbre render --checkpoint'.")
  private List<Path> films;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT",
      required = true,
      description =
          "Picture to write (PNG, JPEG, OpenEXR or PFM); with any other ending, a checkpoint"
              + " file.")
  private Path output;

  @Mixin private final DevelopFlags flags = new DevelopFlags();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run() throws TaskException, FilmMismatchException {
    flags.validate();
    Optional<ImageFormat> format = ImageFormat.of(output);
    if (format.filter(ImageFormat::isVector).isPresent()) {
      new FlagChecks(spec).requirePicture(output);
    }
    boolean isPicture = format.isPresent();
    OutputGuard guard = overwrite.guard();
    films.forEach(film -> guard.readsFilm(film));
    if (isPicture) {
      guard.writes("-o", output, OutputContent.PICTURE);
    } else {
      flags.requireNoDenoising(output);
      guard
          .writes("-o", output, OutputContent.FILM)
          .updates("-o", OutputFile.previous(output), OutputContent.FILM);
    }
    guard.check();
    if (isPicture) {
      flags.develop(output, this::merged, output);
    } else {
      writeFilm();
    }
    return ExitCode.OK;
  }

  private void writeFilm() throws TaskException, FilmMismatchException {
    try (CheckpointFile target = CheckpointFile.reserve(output)) {
      FilmFile merged = merged();
      requireNothingLost(merged.header());
      target.save(new FilmFile(FilmNotes.ofMerged(merged.header()), merged.film()));
      flags.report(merged, output);
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(e.getMessage(), e);
    }
  }

  /** Requires that the merged film has all samples of the one in its place. */
  private void requireNothingLost(FilmHeader merged) throws TaskException {
    if (overwrite.isGiven() || !Files.exists(output)) {
      return;
    }
    FilmHeader before = FilmInput.read(output, errors()).header();
    if (!before.identity().equals(merged.identity())) {
      throw kept("is a checkpoint file of another picture");
    }
    for (FilmPart part : before.parts()) {
      if (merged.parts().stream().noneMatch(other -> other.contains(part))) {
        throw kept("has " + part + ", which the merged films lack");
      }
    }
  }

  private TaskException kept(String why) {
    return ExitCode.OUTPUT.failure(
        "%s: %s; choose another path with -o, or replace the file with --overwrite"
            .formatted(output, why));
  }

  private FilmFile merged() throws TaskException, FilmMismatchException {
    Messages messages = errors();
    List<FilmMerge.Named> named = new ArrayList<>();
    for (Path film : films) {
      FilmFile file = FilmInput.read(film, messages);
      FilmInput.requireNoChoice(film, file.header());
      named.add(new FilmMerge.Named(film.toString(), file));
    }
    return FilmMerge.of(named);
  }
}
