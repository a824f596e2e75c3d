package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import java.io.IOException;
import java.nio.file.Path;

/** Reads films for commands. */
public final class FilmInput {
  private FilmInput() {}

  /**
   * Reads a checkpoint file. If it is damaged, prints a warning and reads the previous version.
   *
   * @throws TaskException if neither can be read
   */
  public static CheckpointFile.Loaded load(Path path, Messages messages) throws TaskException {
    try {
      CheckpointFile.Loaded loaded = CheckpointFile.load(path);
      loaded
          .problem()
          .ifPresent(
              problem ->
                  messages.line(
                      "warning: %s: %s; using %s instead".formatted(path, problem, loaded.from())));
      return loaded;
    } catch (IOException e) {
      throw Failures.ofFilm(path, e);
    }
  }

  /**
   * Requires that the settings of a film say how its paths are split and guided.
   *
   * @throws TaskException if a pilot render of an earlier version chose it
   */
  public static void requireNoChoice(Path path, FilmHeader header) throws TaskException {
    requireNoChoice(path, header, Setting.SPLIT, "--split N");
    requireNoChoice(path, header, Setting.GUIDE, "--guide on or --guide off");
  }

  private static void requireNoChoice(
      Path path, FilmHeader header, Setting<?> setting, String instead) throws TaskException {
    if (SettingType.AUTO.equals(header.identity().get(setting.name()))) {
      throw ExitCode.SCENE.failure(
          "%s: has samples of --%s auto, which earlier versions had; it can be developed and"
                  .formatted(path, setting.name())
              + " denoised, but not resumed or merged: start a new film with "
              + instead);
    }
  }

  /** Reads a film as {@link #load} does. */
  public static FilmFile read(Path path, Messages messages) throws TaskException {
    return load(path, messages).file();
  }
}
