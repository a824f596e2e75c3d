package io.github.lumbre.cli.output;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.TextFile;
import io.github.lumbre.base.file.OutputFile;
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
    return new TextOutput(
        target.isPresent()
            ? Optional.of(Failures.written(() -> OutputFile.open(target.get())))
            : Optional.empty());
  }

  /**
   * Writes the file.
   *
   * @throws TaskException if that fails
   */
  public void write(String text) throws TaskException {
    if (file.isPresent()) {
      Failures.written(
          () -> {
            TextFile.write(file.get(), text);
            return text;
          });
    }
  }

  @Override
  public void close() {
    Failures.close(file);
  }
}
