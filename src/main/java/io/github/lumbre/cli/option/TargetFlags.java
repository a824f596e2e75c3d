package io.github.lumbre.cli.option;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.image.animation.AnimationFormat;
import io.github.lumbre.image.internal.ImageFormat;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Option;

/** The flags that name the pictures of {@code render}. */
public final class TargetFlags extends Flags {
  /** The flags that cannot be combined with several scenes. */
  private static final Set<String> FOR_ONE_SCENE =
      Set.of("--checkpoint", "--dry-run", "--turntable", "--animation");

  /** The further flags that cannot be combined with a contact sheet. */
  private static final Set<String> NOT_FOR_SHEETS = Set.of("--output", "--format", "--layers");

  private static final int MOST_CELLS = 400;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT",
      description = {
        "Picture to write, by its ending: PNG, JPEG, OpenEXR or PFM (linear light) or SVG (lines);"
            + " - for standard output. Or a folder, which exists or has a name without an ending:"
            + " its pictures have the names of their scenes.",
        "Default: the scene's name with .png, in the working directory."
      })
  private Optional<Path> output;

  @Option(
      names = "--format",
      paramLabel = "NAME",
      description =
          "Format of the pictures with -o - or a folder: png, exr, pfm, jpg or svg (png).")
  private Optional<ImageFormat> format;

  @Option(
      names = "--sheet",
      paramLabel = "FILE",
      description =
          "Render all scenes, at most 400, onto one contact sheet, a PNG or JPEG with their names,"
              + " instead of a picture of each; --size is that of a cell's picture (256). A scene"
              + " that fails is an empty cell.")
  private Optional<Path> sheet;

  /** Returns the path of the contact sheet; empty if each scene has a picture of its own. */
  public Optional<Path> sheet() {
    return sheet;
  }

  /** Returns whether the picture is written to standard output. */
  public boolean isStandardOutput() {
    return output.equals(Optional.of(PictureOutput.STANDARD));
  }

  /** Returns the path of the one file that the pictures are joined to; empty if there is none. */
  public Optional<Path> animation() {
    return output.filter(out -> !isFolder() && AnimationFormat.of(out).isPresent());
  }

  /** Returns whether a picture of the command has lines and areas instead of pixels. */
  public boolean isVector() {
    return isStandardOutput() || output.isEmpty() || isFolder()
        ? format().isVector()
        : isVector(output.get());
  }

  private static boolean isVector(Path target) {
    return ImageFormat.of(target).filter(ImageFormat::isVector).isPresent();
  }

  /** Returns the format of a picture that {@code -o} does not name. */
  public ImageFormat format() {
    return format.orElse(ImageFormat.PNG);
  }

  /**
   * Returns the picture of each scene; for a contact sheet, the scenes, which name its cells.
   *
   * @throws TaskException if two scenes have the same picture, also if only the case of letters
   *     differs, which many file systems ignore
   */
  public List<Path> targets(List<Path> scenes) throws TaskException {
    if (sheet.isPresent()) {
      requireSheet(scenes);
      return scenes;
    }
    boolean isFolder = isFolder();
    require(
        format.isEmpty() || isStandardOutput() || isFolder,
        "--format: requires -o - or a folder (-o)");
    if (scenes.size() == 1) {
      return List.of(isFolder ? inFolder(scenes.get(0)) : single(scenes.get(0)));
    }
    requireBatch(scenes);
    if (animation().isPresent()) {
      return List.of(animation().get());
    }
    Optional<String> clash = PictureOutput.clash(scenes, this::inFolder);
    if (clash.isPresent()) {
      throw ExitCode.OUTPUT.failure(clash.get());
    }
    return scenes.stream().map(this::inFolder).toList();
  }

  private void requireSheet(List<Path> scenes) {
    Path file = sheet.orElseThrow();
    require(
        ImageFormat.of(file).filter(ImageFormat::isForScreen).isPresent(),
        "--sheet: expected a name that ends in .png or .jpg, found " + file);
    for (Set<String> flags : List.of(NOT_FOR_SHEETS, FOR_ONE_SCENE)) {
      for (String flag : flags) {
        require(!isGiven(flag), flag + ": cannot be combined with --sheet");
      }
    }
    require(
        scenes.size() <= MOST_CELLS,
        "--sheet: expected at most %d scenes, found %d; make several sheets"
            .formatted(MOST_CELLS, scenes.size()));
    requireFiles(scenes);
  }

  private void requireFiles(List<Path> scenes) {
    require(
        !scenes.contains(PictureOutput.STANDARD),
        "-: standard input cannot be one of several scenes");
  }

  private void requireBatch(List<Path> scenes) {
    for (String flag : FOR_ONE_SCENE) {
      require(!isGiven(flag), flag + ": requires one scene, found " + scenes.size());
    }
    requireFiles(scenes);
    require(
        output.isPresent(),
        scenes.get(1)
            + ": several scenes require a folder for their pictures (-o FOLDER), or one file that"
            + " ends in one of "
            + AnimationFormat.endings());
    require(
        isFolder() || animation().isPresent(),
        "-o: expected a folder for the pictures of several scenes, which exists or has a name"
            + " without an ending, found "
            + output.get());
  }

  /** Returns whether {@code -o} is a folder, which need not exist if its name has no ending. */
  private boolean isFolder() {
    return output.filter(PictureOutput::isFolder).isPresent();
  }

  private Path inFolder(Path scene) {
    return output.orElseThrow().resolve(PictureOutput.defaultFor(scene, format()));
  }

  private Path single(Path scene) {
    Path target = output.orElseGet(() -> PictureOutput.defaultFor(scene, ImageFormat.PNG));
    if (!isStandardOutput() && animation().isEmpty() && !isVector(target)) {
      checks().requirePicture(target);
    }
    return target;
  }
}
