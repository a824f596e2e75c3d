package io.github.lumbre.base;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.file.OutputFile;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;

/** Reads and writes whole text files in UTF-8. */
public final class TextFile {
  private TextFile() {}

  /**
   * Returns the lines of a file.
   *
   * @throws TaskException with the exit code of an invalid command line, if it cannot be read
   */
  public static List<String> lines(Path file) throws TaskException {
    try {
      return Files.readAllLines(file);
    } catch (NoSuchFileException e) {
      throw ExitCode.USAGE.failure(file + ": does not exist", e);
    } catch (IOException e) {
      throw ExitCode.USAGE.failure(file + ": cannot be read: " + FileFailure.reason(e), e);
    }
  }

  /**
   * Writes a file atomically: it appears complete or not at all.
   *
   * @throws TaskException if that fails
   */
  public static void write(Path file, String text) throws TaskException {
    try (OutputFile output = OutputFile.open(file)) {
      write(output, text);
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(e.getMessage(), e);
    }
  }

  /** Writes and commits a reserved file. */
  public static void write(OutputFile output, String text) throws IOException {
    SeekableByteChannel channel = output.restart();
    ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
    while (bytes.hasRemaining()) {
      channel.write(bytes);
    }
    output.commit();
  }
}
