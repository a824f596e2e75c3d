package io.github.lumbre.cli;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.BudgetFlags;
import io.github.lumbre.cli.option.CheckpointFlags;
import io.github.lumbre.cli.option.FlagChecks;
import io.github.lumbre.cli.option.ImportFlag;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.MotionFlags;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.PictureFlags;
import io.github.lumbre.cli.option.QualityFlags;
import io.github.lumbre.cli.option.RenderFlags;
import io.github.lumbre.cli.option.RunFlags;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SequenceFlags;
import io.github.lumbre.cli.option.TargetFlags;
import io.github.lumbre.cli.option.VectorFlags;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.StandardOutput;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.model.Models;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.internal.StagedSheet;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flags of {@code lumbre render}, and what follows from several of them together. */
final class RenderOptions {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Mixin final SceneOptions scene = new SceneOptions();

  @Mixin final ImportFlag imports = new ImportFlag();

  @Mixin final TargetFlags to = new TargetFlags();

  @Mixin final RenderFlags flags = new RenderFlags();

  @Mixin final BudgetFlags budgets = new BudgetFlags();

  @Mixin final QualityFlags quality = new QualityFlags();

  @Mixin final KernelFlag kernel = new KernelFlag();

  @Mixin final PictureFlags stored = new PictureFlags();

  @Mixin final RunFlags run = new RunFlags();

  @Mixin final SequenceFlags sequence = new SequenceFlags();

  @Mixin private final MotionFlags motion = new MotionFlags();

  @Option(
      names = "--checkpoint",
      paramLabel = "FILM",
      description =
          "Save the samples to this new checkpoint file, for 'lumbre resume', 'lumbre merge' and"
              + " 'lumbre develop'.")
  private Optional<Path> checkpoint;

  @Mixin final CheckpointFlags checkpoints = new CheckpointFlags();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  /**
   * Returns whether the picture is lines alone, so that it takes no samples; those of a checkpoint
   * file, of shares and of layers are taken.
   *
   * @throws TaskException if standard input cannot be read
   */
  boolean isDrawing() throws TaskException {
    boolean isSampled =
        checkpoint.isPresent() || flags.samples().haveRange() || !flags.layers().isEmpty();
    return scene.isModel() && !isSampled && StagedSheet.of(scene.model().stage()).isAlone();
  }

  /** Returns the path of the checkpoint file; empty if there is none. */
  Optional<Path> checkpoint() {
    return checkpoint;
  }

  /**
   * Checks all flags before anything is read.
   *
   * @param scenes all scenes of the command
   * @throws ParameterException that names the first one that is wrong
   * @throws TaskException if standard input cannot be read
   */
  void validate(List<Path> scenes) throws TaskException {
    imports.validate();
    scene.importBy(imports);
    if (to.isVector()) {
      requireVectors(scenes);
    }
    flags.validate();
    budgets.validate();
    checkpoints.validate();
    kernel.validate();
    stored.validate();
    sequence.validate(to.animation(), scenes.size());
    validateCheckpoint();
    require(
        !flags.samples().haveShare() || !budgets.areGiven() && quality.targetError().isEmpty(),
        "--share: cannot be combined with --time, --target-error or --quality, because the shares"
            + " would end at different samples");
    require(!to.isStandardOutput() || !run.isJson(), "-o -: cannot be combined with --json");
    require(
        !to.isStandardOutput() || !StandardOutput.isTerminal(),
        "-o -: standard output is a terminal; expected a file or a pipe");
    motion.validate();
    flags.expose(settings -> motion.override(settings, sequence.rate()));
    if (sequence.areGiven()) {
      require(
          scene.isModel() && checkpoint.isEmpty() && !to.isStandardOutput(),
          sequence.name()
              + ": requires a model file, and cannot be combined with --checkpoint or -o -");
      scene.move(sequence.motion().orElseThrow());
    }
  }

  /** Makes the pictures drawings of lines, and requires that no flag asks for more. */
  private void requireVectors(List<Path> scenes) throws TaskException {
    for (Path each : scenes) {
      scene.choose(each);
      require(scene.isModel(), each + ": expected a model for an .svg file: " + Models.NAMES);
    }
    scene.choose(scenes.get(0));
    VectorFlags.require(spec);
    scene.model().drawLines();
  }

  private void validateCheckpoint() {
    require(
        !quality.isAdaptive() || checkpoint.isEmpty() && !flags.samples().haveRange(),
        "--adaptive: cannot be combined with --checkpoint, --samples-from or --samples-to, because"
            + " a checkpoint file does not record which samples come next");
    require(
        !flags.samples().haveShare() || checkpoint.isPresent(),
        "--share: requires --checkpoint, whose files 'lumbre merge' joins");
    require(
        !flags.isClamping() || checkpoint.isEmpty(),
        "--clamp: cannot be combined with --checkpoint, because a checkpoint file does not record"
            + " the clamped energy");
    for (String drawn : List.of("labels", "hidden")) {
      require(
          checkpoint.isEmpty()
              || !spec.commandLine().getParseResult().hasMatchedOption("--" + drawn),
          ("--%s: cannot be combined with --checkpoint, because a checkpoint file does not record"
                  + " the %s")
              .formatted(drawn, drawn.equals("hidden") ? "hidden lines" : drawn));
    }
    require(
        checkpoint.isEmpty() || !scene.isStandardInput() && !to.isStandardOutput(),
        "--checkpoint: expected files for the scene and the picture, found -; 'lumbre resume' needs"
            + " both files");
  }

  /** Returns the target error of the flags; empty if there is none. */
  OptionalDouble targetError() {
    OptionalDouble ofBudget = budgets.targetError();
    return ofBudget.isPresent() ? ofBudget : quality.targetError();
  }

  /**
   * Prints the heap that a large model takes, unless nothing but warnings shall be printed; returns
   * the scene, which has not been read.
   *
   * @throws TaskException if standard input cannot be read
   */
  SceneOptions announced() throws TaskException {
    run.announce(scene);
    return scene;
  }

  /**
   * Returns the parser of the scene, with the settings of the flags. A drawing traces few rays.
   *
   * @throws TaskException if standard input cannot be read
   */
  SceneParser parser() throws TaskException {
    boolean isOpen = budgets.areGiven() || quality.targetError().isPresent();
    SceneParser any = kernel.over(scene.parser(), budgets.time());
    SceneParser parser = isDrawing() ? any.searchedLater() : any;
    return flags.over(parser, isOpen, quality.isAdaptive(), quality.depth());
  }

  /**
   * Chooses the denoiser of the scene's picture, and the samples and layers that it needs. With a
   * checkpoint file the picture has the noise of the picture that {@code resume} writes.
   *
   * @return the denoiser; empty if the picture keeps its noise
   * @throws TaskException if the denoiser's program is not found
   */
  Optional<Denoising> denoising(Path target, Engine engine) throws TaskException {
    boolean isDefault =
        scene.isModel()
            && format(to.sheet().orElse(target)).filter(ImageFormat::isForScreen).isPresent()
            && !flags.isRayMode()
            && checkpoint.isEmpty()
            && engine == Engine.LOCAL;
    Optional<Denoising> denoising =
        isDrawing() ? Optional.empty() : stored.denoising().denoising(isDefault);
    boolean isUsual = denoising.isPresent() && scene.isModel() && !quality.isAdaptive();
    flags.recordForDenoising(
        denoising.isPresent(),
        isUsual ? OptionalInt.of(Denoising.MODEL_SAMPLES) : OptionalInt.empty());
    return denoising;
  }

  /** Returns the number of bits per channel of a PNG. */
  int bits() {
    return stored.bits().orElse(ImageWriter.Options.DEFAULT.pngBits());
  }

  private Optional<ImageFormat> format(Path target) {
    return to.isStandardOutput() ? Optional.of(to.format()) : ImageFormat.of(target);
  }

  /**
   * Checks and reserves the files of all pictures.
   *
   * @throws TaskException if a file must not or cannot be written
   */
  void reserve(List<Path> scenes, Frames frames) throws TaskException {
    Path target = frames.targets().get(0);
    require(
        flags.layers().isEmpty()
            || checkpoint.isPresent()
            || format(target).equals(Optional.of(ImageFormat.EXR)),
        "--layers: expected an .exr picture (-o) or --checkpoint, which hold layers, found "
            + target);
    checkOutputs(scenes, "-o", frames.targets());
    if (to.isStandardOutput()) {
      frames.reserve(PictureOutput.toStandardOutput(to.format(), checkpoints.fallback()));
    } else {
      frames.reserve(checkpoints.fallback());
    }
  }

  /**
   * Checks that the command may write its files.
   *
   * @param flag flag that sets the paths
   * @param targets paths of the pictures
   */
  void checkOutputs(List<Path> scenes, String flag, List<Path> targets) throws TaskException {
    OutputGuard guard = overwrite.guard();
    if (scenes.size() > 1) {
      scene.guardAll(scenes, guard);
    } else {
      scene.guardedBy(guard);
    }
    if (!to.isStandardOutput()) {
      targets.forEach(target -> guard.writes(flag, target, OutputContent.PICTURE));
    }
    to.animation().ifPresent(file -> guard.writes("-o", file, OutputContent.ANIMATION));
    // An existing checkpoint file is rejected later, with the advice to resume it.
    checkpoint.ifPresent(film -> guard.updatesFilm("--checkpoint", film));
    guard.check();
  }

  private void require(boolean condition, String message) {
    new FlagChecks(spec).require(condition, message);
  }
}
