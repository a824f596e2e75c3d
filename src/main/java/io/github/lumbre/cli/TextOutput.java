package io.github.lumbre.cli;

import io.github.lumbre.image.OutputFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A file of text that may have been asked for: its place is reserved before the work, so that a
 * missing folder is known then. Closed without a text, it leaves everything as it was.
 */
final class TextOutput implements AutoCloseable {
  private final Optional<OutputFile> file;

  private TextOutput(Optional<OutputFile> file) {
    this.file = file;
  }

  /**
   * Reserves the place; without one, what is written goes nowhere.
   *
   * @throws CommandException if nothing can be written there
   */
  static TextOutput reserve(Optional<Path> target) throws CommandException {
    if (target.isEmpty()) {
      return new TextOutput(Optional.empty());
    }
    try {
      return new TextOutput(Optional.of(OutputFile.open(target.get())));
    } catch (IOException e) {
      throw failure(e);
    }
  }

  /**
   * Writes the file.
   *
   * @throws CommandException if that fails
   */
  void write(String text) throws CommandException {
    try {
      if (file.isPresent()) {
        TextFile.write(file.get(), text);
      }
    } catch (IOException e) {
      throw failure(e);
    }
  }

  @Override
  public void close() throws CommandException {
    try {
      if (file.isPresent()) {
        file.get().close();
      }
    } catch (IOException e) {
      throw failure(e);
    }
  }

  private static CommandException failure(IOException e) {
    return new CommandException(ExitCodes.OUTPUT, e.getMessage(), e);
  }
}
