package io.github.lumbre.cli;

import io.github.lumbre.checkpoint.CheckpointFile;
import io.github.lumbre.checkpoint.FilmFile;
import io.github.lumbre.checkpoint.FilmFormatException;
import io.github.lumbre.image.FileFailure;
import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Reads films for commands. */
final class FilmInput {
  private FilmInput() {}

  /**
   * Reads a film, or the one saved before it if it is damaged, which is told.
   *
   * @throws CommandException if neither can be read
   */
  static CheckpointFile.Loaded load(Path path, Messages messages) throws CommandException {
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
                          + "; uses "
                          + loaded.from()
                          + " instead"));
      return loaded;
    } catch (NoSuchFileException e) {
      throw new CommandException(ExitCodes.SCENE, path + ": does not exist", e);
    } catch (FilmFormatException e) {
      throw new CommandException(ExitCodes.SCENE, path + ": " + e.getMessage(), e);
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.SCENE, path + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }

  /** Reads a film; see {@link #load}. */
  static FilmFile read(Path path, Messages messages) throws CommandException {
    return load(path, messages).file();
  }
}
