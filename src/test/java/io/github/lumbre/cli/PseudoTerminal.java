package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A terminal whose keyboard and screen a test controls, created by {@code script} of util-linux.
 */
final class PseudoTerminal implements AutoCloseable {
  private static final long PATIENCE_SECONDS = 60;
  private static final Pattern ESCAPE = Pattern.compile("\033\\[[0-9;?]*([A-Za-z])");

  private final Process script;
  private final Path device;
  private final OutputStream keyboard;
  private final Thread reader;
  private final StringBuilder printed = new StringBuilder();

  private PseudoTerminal(Process script, Path device) {
    this.script = script;
    this.device = device;
    keyboard = script.getOutputStream();
    reader = new Thread(this::read, "pseudo-terminal");
    reader.setDaemon(true);
    reader.start();
  }

  /** Returns whether this system can create one. */
  static boolean isSupported() throws InterruptedException {
    try {
      Process process = new ProcessBuilder("script", "--version").redirectErrorStream(true).start();
      String version = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return process.waitFor() == 0 && version.contains("util-linux");
    } catch (IOException e) {
      return false;
    }
  }

  /** Runs a line of the shell in a new terminal of the type xterm. */
  static PseudoTerminal run(
      Path directory, int columns, Map<String, String> environment, String command)
      throws IOException, InterruptedException {
    Path device = directory.resolve("device.txt");
    Files.deleteIfExists(device);
    // With another name first, so that the file is complete when it appears.
    String prepared =
        "stty rows 24 cols " + columns + "; tty >device.new; mv device.new device.txt; " + command;
    ProcessBuilder builder =
        new ProcessBuilder(
                Program.interruptible(
                    List.of("script", "-q", "-e", "-f", "-c", prepared, "/dev/null")))
            .directory(directory.toFile())
            .redirectErrorStream(true);
    builder.environment().put("TERM", "xterm");
    builder.environment().put("SHELL", "/bin/sh");
    builder.environment().remove("COLUMNS");
    builder.environment().putAll(environment);
    Process script = builder.start();
    PseudoTerminal terminal = new PseudoTerminal(script, device);
    terminal.await("the terminal", screen -> Files.exists(device));
    return terminal;
  }

  private void read() {
    byte[] block = new byte[4096];
    try (InputStream in = script.getInputStream()) {
      for (int count = in.read(block); count >= 0; count = in.read(block)) {
        synchronized (printed) {
          printed.append(new String(block, 0, count, StandardCharsets.ISO_8859_1));
        }
      }
    } catch (IOException e) {
      // The terminal is closed.
      return;
    }
  }

  /** Returns the complete output, with control characters. */
  String printed() {
    synchronized (printed) {
      return printed.toString();
    }
  }

  /** Returns the number of printed characters. */
  int length() {
    synchronized (printed) {
      return printed.length();
    }
  }

  /** Returns the complete lines that the progress bar has drawn since a position in the output. */
  List<String> bars(int from) {
    List<String> bars = new ArrayList<>();
    Matcher matcher = Pattern.compile("\r([^\r\n\033]+)\033\\[K\r").matcher(printed());
    while (matcher.find()) {
      if (matcher.start() >= from) {
        bars.add(matcher.group(1));
      }
    }
    return bars;
  }

  /** Returns the lines on the screen now, without blank ones; no line is wrapped. */
  List<String> screen() {
    List<StringBuilder> lines = new ArrayList<>(List.of(new StringBuilder()));
    int column = 0;
    String text = printed();
    Matcher escape = ESCAPE.matcher(text);
    for (int at = 0; at < text.length(); at++) {
      StringBuilder line = lines.get(lines.size() - 1);
      char c = text.charAt(at);
      if (c == '\r') {
        column = 0;
      } else if (c == '\n') {
        lines.add(new StringBuilder());
      } else if (escape.region(at, text.length()).lookingAt()) {
        line.setLength(Math.min(line.length(), column));
        at = escape.end() - 1;
      } else {
        line.append(" ".repeat(Math.max(0, column + 1 - line.length())));
        line.setCharAt(column++, c);
      }
    }
    return lines.stream()
        .map(line -> line.toString().stripTrailing())
        .filter(line -> !line.isEmpty())
        .toList();
  }

  /** Presses keys. */
  void type(String keys) throws IOException {
    keyboard.write(keys.getBytes(StandardCharsets.ISO_8859_1));
    keyboard.flush();
  }

  /** Presses Ctrl and a letter. */
  void control(char letter) throws IOException {
    type(String.valueOf((char) (letter - '@')));
  }

  /** Changes the width of the window; the kernel sends SIGWINCH. */
  void resize(int columns) throws IOException, InterruptedException {
    String name = Files.readString(device).strip();
    assertThat(
            new ProcessBuilder("stty", "-F", name, "cols", String.valueOf(columns))
                .start()
                .waitFor())
        .isZero();
  }

  /** Closes the window: the kernel sends SIGHUP to the shell in it. */
  void closeWindow() throws InterruptedException {
    script.destroyForcibly().waitFor();
  }

  boolean isAlive() {
    return script.isAlive();
  }

  /** Waits until a condition on the complete output is true. */
  void await(String what, Predicate<String> condition) throws InterruptedException {
    long start = System.nanoTime();
    while (!condition.test(printed())) {
      long seconds = TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start);
      assertThat(seconds)
          .as("seconds without %s:%n%s", what, printed())
          .isLessThan(PATIENCE_SECONDS);
      assertThat(script.isAlive() || condition.test(printed()))
          .as("ended without %s:%n%s", what, printed())
          .isTrue();
      Thread.sleep(5);
    }
  }

  /** Waits for the end and returns the exit code. */
  int exitCode() throws InterruptedException {
    assertThat(script.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS))
        .as("still running:%n%s", printed())
        .isTrue();
    reader.join();
    return script.exitValue();
  }

  @Override
  public void close() {
    script.descendants().forEach(ProcessHandle::destroyForcibly);
    script.destroyForcibly();
  }
}
