package io.github.lumbre.cli.output;

import io.github.lumbre.file.OutputFile;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.TextFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A file of text that may have been asked for: its place is reserved before the work, so that a
 * missing folder is known then. Closed without a text, it leaves everything as it was.
 */
public final class TextOutput implements AutoCloseable {
  private final Optional<OutputFile> file;

  private TextOutput(Optional<OutputFile> file) {
    this.file = file;
  }

  /**
   * Reserves the place; without one, what is written goes nowhere.
   *
   * @throws TaskException if nothing can be written there
   */
  public static TextOutput reserve(Optional<Path> target) throws TaskException {
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
   * @throws TaskException if that fails
   */
  public void write(String text) throws TaskException {
    try {
      if (file.isPresent()) {
        TextFile.write(file.get(), text);
      }
    } catch (IOException e) {
      throw failure(e);
    }
  }

  @Override
  public void close() throws TaskException {
    try {
      if (file.isPresent()) {
        file.get().close();
      }
    } catch (IOException e) {
      throw failure(e);
    }
  }

  private static TaskException failure(IOException e) {
    return new TaskException(Kind.OUTPUT, e.getMessage(), e);
  }
}
