package io.github.lumbre.cli.output;

import io.github.lumbre.base.ExitCode;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.Optional;

/**
 * A stream of results that records its first failure, which a {@link PrintWriter} hides. Mutable,
 * not thread-safe.
 */
public final class StandardOutput extends OutputStream {
  private final OutputStream stream;
  private Optional<IOException> failure = Optional.empty();

  StandardOutput(OutputStream stream) {
    this.stream = stream;
  }

  /** Returns standard output itself. */
  public static StandardOutput open() {
    return new StandardOutput(new FileOutputStream(FileDescriptor.out));
  }

  /** Returns whether standard output is known to be a terminal. */
  public static boolean isTerminal() {
    // From Java 22 on, there can be a console without a terminal.
    boolean isConsole = Runtime.version().feature() < 22 && System.console() != null;
    return Boolean.getBoolean("lumbre.stdout.tty") || isConsole;
  }

  @Override
  public void write(int value) throws IOException {
    write(new byte[] {(byte) value}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    try {
      stream.write(bytes, offset, length);
    } catch (IOException e) {
      failure = failure.or(() -> Optional.of(e));
      throw e;
    }
  }

  /**
   * Returns the exit code of the program after a command: {@link ExitCode#OUTPUT} if the command
   * succeeded but its result could not be printed. Prints the error, unless the reader of a pipe
   * has ended, as {@code head} does once it has what it wants.
   */
  public int exitCode(int ofCommand, PrintWriter errors) {
    boolean isAnswer = ofCommand <= ExitCode.DIFFERENT.number();
    if (failure.isEmpty() || !isAnswer) {
      return ofCommand;
    }
    String reason = String.valueOf(failure.get().getMessage());
    // Systems in other languages repeat the English words, in lower case.
    if (!reason.toLowerCase(Locale.ROOT).contains("broken pipe")) {
      new Messages(errors).error("standard output cannot be written: " + reason);
    }
    return ExitCode.OUTPUT.number();
  }
}
