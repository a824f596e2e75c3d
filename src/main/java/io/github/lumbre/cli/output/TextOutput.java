package io.github.lumbre.cli.output;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.TextFile;
import io.github.lumbre.base.file.OutputFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * An optional text file, reserved before the work starts, so that a missing folder is reported
 * early. If it is closed without a text, existing files are unchanged.
 */
public final class TextOutput implements AutoCloseable {
  private final Optional<OutputFile> file;

  private TextOutput(Optional<OutputFile> file) {
    this.file = file;
  }

  /**
   * Reserves the file; without a target, the text is discarded.
   *
   * @throws TaskException if the file cannot be written
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
    return ExitCode.OUTPUT.failure(e.getMessage(), e);
  }
}
