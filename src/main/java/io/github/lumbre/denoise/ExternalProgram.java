package io.github.lumbre.denoise;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Runs an installed program to its end, within a time limit.
 *
 * @param program path of the program, for messages
 * @param limit time after which it is ended
 */
record ExternalProgram(Path program, Duration limit) {
  private static final int MAX_LOG = 1 << 16;
  private static final int SHOWN = 200;

  /**
   * Runs a command and returns the start of its output.
   *
   * @throws DenoiseException if the program does not start, takes too long, or fails
   * @throws InterruptedException if the thread is interrupted; the program is ended
   */
  String run(List<String> command) throws DenoiseException, InterruptedException {
    Process process;
    try {
      process = new ProcessBuilder(command).redirectErrorStream(true).start();
      process.getOutputStream().close();
    } catch (IOException e) {
      throw new DenoiseException(program + ": does not start: " + e.getMessage(), e);
    }
    FutureTask<String> said = new FutureTask<>(() -> said(process.getInputStream()));
    Thread listener = new Thread(said, "listening to " + program.getFileName());
    listener.setDaemon(true);
    listener.start();
    try {
      if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
        throw new DenoiseException(
            program + ": took longer than " + limit.toMillis() / 1000.0 + " s and was ended");
      }
    } finally {
      end(process);
    }
    String text = get(said);
    if (process.exitValue() != 0) {
      throw new DenoiseException(
          program + ": failed with code " + process.exitValue() + lastLine(text));
    }
    return text;
  }

  private static void end(Process process) {
    // Destroying an ended process would close what it said before it is read.
    if (process.isAlive()) {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
  }

  /** Reads all, so that the program does not wait, and keeps the start. */
  private static String said(InputStream in) throws IOException {
    byte[] start = in.readNBytes(MAX_LOG);
    in.transferTo(OutputStream.nullOutputStream());
    return new String(start, StandardCharsets.UTF_8);
  }

  /**
   * Returns the output of the ended program; nothing if a process that it left behind still writes.
   */
  private static String get(FutureTask<String> said) throws InterruptedException {
    try {
      return said.get(1, TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      return "";
    }
  }

  private static String lastLine(String said) {
    String last = said.lines().filter(line -> !line.isBlank()).reduce("", (a, b) -> b).strip();
    String shown = last.substring(0, Math.min(SHOWN, last.length())).replaceAll("\\p{Cntrl}", " ");
    return shown.isEmpty() ? "" : ": " + shown;
  }
}
