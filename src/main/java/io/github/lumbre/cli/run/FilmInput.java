package io.github.lumbre.cli.run;

import io.github.lumbre.checkpoint.CheckpointFile;
import io.github.lumbre.checkpoint.FilmFile;
import io.github.lumbre.checkpoint.FilmFormatException;
import io.github.lumbre.checkpoint.FilmHeader;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.file.FileFailure;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import java.io.IOException;
import java.nio.file.NoSuchFileException;
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
                      "warning: "
                          + path
                          + ": "
                          + problem
                          + "; using "
                          + loaded.from()
                          + " instead"));
      return loaded;
    } catch (NoSuchFileException e) {
      throw new TaskException(Kind.SCENE, path + ": does not exist", e);
    } catch (FilmFormatException e) {
      throw new TaskException(Kind.SCENE, path + ": " + e.getMessage(), e);
    } catch (IOException e) {
      throw new TaskException(Kind.SCENE, path + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }

  /**
   * Requires that the paths of a film are split into a number of branches.
   *
   * @throws TaskException if a pilot render of an earlier version chose the numbers
   */
  public static void requireFixedSplit(Path path, FilmHeader header) throws TaskException {
    if (SettingType.AUTO.equals(header.identity().get(Setting.SPLIT.name()))) {
      throw new TaskException(
          Kind.SCENE,
          path
              + ": has samples of --split auto, which earlier versions had; it can be developed and"
              + " denoised, but not resumed or merged: start a new film with --split N");
    }
  }

  /** Reads a film as {@link #load} does. */
  public static FilmFile read(Path path, Messages messages) throws TaskException {
    return load(path, messages).file();
  }
}
