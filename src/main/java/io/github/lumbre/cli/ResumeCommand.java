package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.option.BudgetFlags;
import io.github.lumbre.cli.option.CheckpointFlags;
import io.github.lumbre.cli.option.ImportFlag;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.RunFlags;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.run.Deadline;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.FilmInput;
import io.github.lumbre.cli.run.FilmKeeper;
import io.github.lumbre.cli.run.FilmNotes;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.PictureExposure;
import io.github.lumbre.cli.run.RenderJob;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.run.RunBudget;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.FilmMismatchException;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting.Group;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.SceneText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre resume}: resumes a stopped render, or adds samples to a finished one. */
@Command(
    name = "resume",
    header = "Resume a render from its checkpoint file.",
    description =
        "Resume a stopped render or add samples to a finished one. The picture is bit-identical to"
            + " the picture of an uninterrupted render. The scene and its files must be unchanged.",
    modelTransformer = SettingFlags.Adder.class,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre render scene.json -s 4000 --checkpoint night.film",
      "  lumbre resume night.film",
      "  lumbre resume night.film -s 8000",
      "  lumbre resume night.film --target-error 1%% --time 8h"
    })
@Exits({
  ExitCode.OK, ExitCode.PARTIAL, ExitCode.TARGET, ExitCode.SCENE, ExitCode.FILM, ExitCode.ASSET,
  ExitCode.LIMIT, ExitCode.LATE, ExitCode.OUTPUT, ExitCode.SAVED
})
final class ResumeCommand extends Subcommand {
  /** The number of samples per pixel that means no limit. */
  private static final int OPEN = RenderSettings.MAX_SAMPLES;

  private final Engine engine;

  @Parameters(
      paramLabel = "FILM",
      description = "Checkpoint file from 'lumbre render --checkpoint'.")
  private Path film;

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      description =
          "Samples per pixel, including those already rendered (as before; if these are complete,"
              + " no limit with --time or --target-error).")
  private Optional<Integer> samples;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT",
      description = "Picture to write (as before; a merged film needs one).")
  private Optional<Path> output;

  @Option(
      names = "--scene",
      paramLabel = "SCENE",
      description = "Scene file, if it has moved (as before).")
  private Optional<Path> scene;

  @Option(
      names = "--assets",
      paramLabel = "DIR",
      description =
          "Further folder from which files of the model may come, as when rendering began."
              + " Repeatable.")
  private List<Path> assets = List.of();

  @Mixin private final SettingFlags work = new SettingFlags("", Group.EXECUTION);

  @Mixin private final BudgetFlags budgets = new BudgetFlags();

  @Mixin private final KernelFlag kernel = new KernelFlag();

  @Mixin private final RunFlags run = new RunFlags();

  @Mixin private final CheckpointFlags checkpoints = new CheckpointFlags();

  @Mixin private final ImportFlag imports = new ImportFlag();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run() throws Exception {
    JsonSummary report = new JsonSummary("resume", "film", film);
    try (Interruption interruption = Interruption.listen()) {
      return run.border(interruption, Optional.empty())
          .of(report, () -> run(report, interruption));
    }
  }

  private ExitCode run(JsonSummary report, Interruption interruption) throws Exception {
    validate();
    Deadline deadline = run.deadline();
    Instant start = budgets.start();
    Duration startup = Duration.between(start, Instant.now());
    try (FilmKeeper keeper = checkpoints.keeper(film, run.errors())) {
      CheckpointFile.Loaded loaded = FilmInput.load(film, run.errors());
      FilmHeader header = loaded.file().header();
      FilmInput.requireNoChoice(film, header);
      requireNoGaps(header);
      FilmNotes notes = new FilmNotes(film, header);
      Path target = target(notes);
      Path path = scene.isPresent() ? scene.get() : notes.scene();
      Optional<SceneText> text = notes.sceneText(path);
      OutputGuard guard = overwrite.guard();
      if (text.isPresent()) {
        guard.reads(path, "the model");
      } else {
        guard.readsScene(path);
      }
      guard
          .updatesFilm("FILM", film)
          .updates("FILM", damaged(), OutputContent.FILM)
          .writes("-o", target, OutputContent.PICTURE)
          .check();
      try (PictureOutput picture = PictureOutput.reserve(target, checkpoints.fallback());
          RenderMonitor monitor = run.monitor(interruption, deadline)) {
        report.put("scene", path.toString());
        SceneFile file = monitor.reading(path, () -> parse(notes, header, path));
        if (text.isPresent()) {
          guard.checkAssets(path, file.assetPaths(text.get().path()));
        }
        RunBudget budget = budget(notes, file.settings(), start, startup);
        MemoryCheck.require(file.settings(), FilmLayers.of(file.settings(), file.scene()));
        interruption.requireRender();
        setDamagedAside(loaded);
        Map<String, String> kept =
            FilmNotes.of(path, file, target, notes.bits(), notes.lenient(), budget);
        keeper.begin(
            header.identity(),
            header.layers(),
            () -> kept,
            header.faults(),
            file.settings());
        RenderJob job =
            new RenderJob(
                path,
                file,
                picture,
                keeper,
                monitor,
                run.errors(),
                report,
                budget,
                run.jobOptions(
                    notes.bits(),
                    ImageWriter.Options.DEFAULT_JPEG_QUALITY,
                    false,
                    Optional.empty(),
                    file.settings().layers(),
                    PictureExposure.ofEach(),
                    drawn -> {}),
                engine);
        return job.run(loaded.file());
      }
    }
  }

  /** Creates the command that renders in this process. */
  ResumeCommand() {
    this(Engine.LOCAL);
  }

  ResumeCommand(Engine engine) {
    this.engine = engine;
  }

  private void validate() throws TaskException {
    samples.ifPresent(n -> requireIn("--samples", 1, RenderSettings.MAX_SAMPLES, n));
    work.validate(spec);
    budgets.validate();
    checkpoints.validate();
    kernel.validate();
    imports.validate();
    checks().requireFolders("--assets", assets);
    if (!Files.exists(film) && !Files.exists(OutputFile.previous(film))) {
      throw ExitCode.SCENE.failure(film + ": does not exist");
    }
  }

  /** Returns the budget that the flags set; without such flags, with the film's target error. */
  private RunBudget budget(
      FilmNotes notes, RenderSettings settings, Instant start, Duration startup)
      throws TaskException {
    boolean asBefore = samples.isEmpty() && !budgets.areGiven();
    OptionalDouble error = asBefore ? notes.targetError() : OptionalDouble.empty();
    if (asBefore && error.isEmpty() && settings.samples() == RenderSettings.MAX_SAMPLES) {
      throw ExitCode.USAGE.failure(
          film
              + ": was rendered without a sample limit; expected --samples, --time or"
              + " --target-error");
    }
    return budgets.since(start, startup, budgets.time(), settings, error, notes.confidence());
  }

  private Path target(FilmNotes notes) throws TaskException {
    Optional<Path> target = output.isPresent() ? output : notes.output();
    return target.orElseThrow(
        () ->
            ExitCode.USAGE.failure(
                film + ": has no picture yet, because it was merged; expected one with -o"));
  }

  private void requireNoGaps(FilmHeader header) throws TaskException {
    if (header.hasGaps()) {
      throw ExitCode.SCENE.failure(
          film + ": cannot be resumed, because its samples have gaps: " + header.parts());
    }
  }

  /** Reads the film's scene with the film's settings, overridden by the flags. */
  private SceneFile parse(FilmNotes notes, FilmHeader header, Path path)
      throws TaskException, SceneFormatException, FilmMismatchException, IOException {
    int most = header.parts().get(0).most();
    int limit =
        samples.orElse(budgets.areGiven() && notes.samples() == most ? OPEN : notes.samples());
    if (limit < most) {
      throw ExitCode.USAGE.failure(
          "--samples: expected at least the %s per pixel already rendered, found %s"
              .formatted(Numbers.count(most, "sample"), limit));
    }
    SceneParser parser =
        kernel.over(
            notes.parser(
                settings -> {
                  settings.samples(limit);
                  work.override(settings);
                }),
            budgets.time());
    Optional<Imported> imported = imported(header, path);
    SceneFile file = notes.read(parser.withAssets(assets), path, imported);
    requireSameFiles(notes, header, file, path);
    requireSame(header, file, path);
    run.errors().warnings(file.warnings());
    return file;
  }

  /** Returns the model of the film, converted again; empty if it was not converted. */
  private Optional<Imported> imported(FilmHeader header, Path path) throws TaskException {
    String before = header.identity().get(FilmHeader.CONVERTED_HASH);
    require(
        imports.isGiven() == (before != null),
        "--import-with: "
            + (before == null
                ? "cannot be used; the model of the checkpoint file was not converted"
                : "required as when rendering began, to convert " + path + " again"));
    if (before == null) {
      return Optional.empty();
    }
    Imported imported = imports.imported(path);
    if (!imported.hash().equals(before)) {
      throw ExitCode.SCENE.failure(
          "%s: the program of --import-with has converted %s to other bytes than before, so that"
                  .formatted(film, path)
              + " the film cannot be resumed, only developed");
    }
    return Optional.of(imported);
  }

  private void requireSameFiles(FilmNotes notes, FilmHeader header, SceneFile file, Path path)
      throws TaskException {
    if (file.hash().equals(header.identity().get(FilmHeader.SCENE_HASH))) {
      return;
    }
    List<String> changed = notes.changedFiles(path, file);
    String what =
        changed.isEmpty()
            ? path + " or a file that it uses has"
            : String.join(", ", changed) + (changed.size() == 1 ? " has" : " have");
    throw ExitCode.SCENE.failure(
        film
            + ": "
            + what
            + " changed since the checkpoint file was created; to resume, restore the files, or"
            + " name an unchanged copy of the scene with --scene COPY"
            + (notes.sceneText(path).isPresent() ? ", or folders of its files with --assets" : ""));
  }

  private void requireSame(FilmHeader header, SceneFile file, Path path)
      throws FilmMismatchException {
    Map<String, String> here =
        new LinkedHashMap<>(FilmHeader.identity(file.hash(), file.settings()));
    // The pilot render is compared when it is rendered; a converted model has been.
    for (String name : List.of(FilmHeader.GUIDE_HASH, FilmHeader.CONVERTED_HASH)) {
      Optional.ofNullable(header.identity().get(name)).ifPresent(hash -> here.put(name, hash));
    }
    header.requireSame(here, film.toString(), path.toString());
  }

  private Path damaged() {
    return film.resolveSibling(film.getFileName() + ".damaged");
  }

  /** Renames a damaged film, so that the next save does not put it in place of the good one. */
  private void setDamagedAside(CheckpointFile.Loaded loaded) throws TaskException {
    if (loaded.problem().isEmpty() || !Files.exists(film)) {
      return;
    }
    Path aside = damaged();
    try {
      Files.move(film, aside, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(
          film + ": cannot be renamed to " + aside + ": " + e.getMessage(), e);
    }
    run.errors().line("warning: " + film + ": damaged file kept as " + aside);
  }
}
