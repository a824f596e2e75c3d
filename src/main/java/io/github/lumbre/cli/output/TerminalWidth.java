package io.github.lumbre.cli.output;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;

/**
 * The number of columns of the terminal. It is measured again after SIGWINCH (window resized) and
 * SIGCONT (program resumed). Mutable and thread-safe.
 */
public final class TerminalWidth implements AutoCloseable {
  private static final int DEFAULT = 80;
  private static final long PATIENCE_MILLIS = 1000;

  private final Supplier<Optional<Integer>> query;
  private final AtomicBoolean changed = new AtomicBoolean(true);
  private volatile int columns = DEFAULT;

  private TerminalWidth(Supplier<Optional<Integer>> query) {
    this.query = query;
  }

  /** Returns the width of the terminal that controls this process. */
  static TerminalWidth watching() {
    TerminalWidth width = new TerminalWidth(TerminalWidth::ofTerminal);
    Signals.on("WINCH", width::change);
    Signals.on("CONT", width::change);
    return width;
  }

  /** Returns a width that is measured on first use and after each {@link #change}. */
  static TerminalWidth measuredBy(Supplier<Optional<Integer>> query) {
    return new TerminalWidth(query);
  }

  /** Marks the width as outdated, so that the next use measures it again. */
  void change() {
    changed.set(true);
  }

  /** Returns the number of columns; the variable COLUMNS or else 80 if it cannot be measured. */
  int columns() {
    if (changed.getAndSet(false)) {
      columns = query.get().or(TerminalWidth::ofEnvironment).orElse(DEFAULT);
    }
    return columns;
  }

  @Override
  public void close() {
    changed.set(false);
  }

  private static Optional<Integer> ofEnvironment() {
    return parsed(System.getenv().getOrDefault("COLUMNS", ""));
  }

  private static Optional<Integer> ofTerminal() {
    try {
      Process stty =
          new ProcessBuilder("stty", "size")
              .redirectInput(new File("/dev/tty"))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      if (!stty.waitFor(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
        stty.destroy();
        return Optional.empty();
      }
      String answer = new String(stty.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
      return parsed(answer.substring(answer.indexOf(' ') + 1));
    } catch (IOException e) {
      return Optional.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }

  /** Returns the parsed number of columns, 1 to 99999; empty if the text is not such a number. */
  static Optional<Integer> parsed(String text) {
    String digits = text.strip();
    return digits.matches("[1-9][0-9]{0,4}")
        ? Optional.of(Integer.parseInt(digits))
        : Optional.empty();
  }
}
