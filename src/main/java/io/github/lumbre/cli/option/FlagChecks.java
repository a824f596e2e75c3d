package io.github.lumbre.cli.option;

import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.internal.FrameSize;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Checks of a command line that is syntactically valid. */
public record FlagChecks(CommandSpec spec) {
  /**
   * Requires a condition.
   *
   * @throws ParameterException with the message if the condition does not hold
   */
  public void require(boolean condition, String message) {
    if (!condition) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }

  /**
   * Requires a flag's value to lie in a closed range.
   *
   * @throws ParameterException that names the flag if the value does not
   */
  public void requireIn(String flag, int low, int high, int found) {
    require(
        low <= found && found <= high,
        flag + ": expected " + low + " to " + high + ", found " + found);
  }

  /**
   * Requires the name of a picture that can be written.
   *
   * @throws ParameterException if its ending is unknown
   */
  public void requirePicture(Path file) {
    require(
        ImageFormat.of(file).filter(format -> !format.isVector()).isPresent(),
        file + ": expected a name that ends in one of " + ImageFormat.endings());
  }

  /**
   * Requires folders that exist.
   *
   * @throws ParameterException that names the flag and the first one that does not
   */
  public void requireFolders(String flag, List<Path> folders) {
    for (Path folder : folders) {
      String found = Files.exists(folder) ? "a file" : "none";
      require(
          Files.isDirectory(folder),
          flag + ": expected a folder, found " + found + " at " + folder);
    }
  }

  /**
   * Requires the sides of {@code --size} to be possible.
   *
   * @throws ParameterException if one is too large or 0
   */
  public void requireSize(FrameSize size) {
    requireIn("--size", 1, RenderSettings.MAX_SIDE, size.width());
    size.height().ifPresent(n -> requireIn("--size", 1, RenderSettings.MAX_SIDE, n));
  }
}
