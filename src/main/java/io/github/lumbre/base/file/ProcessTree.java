package io.github.lumbre.base.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * A started program and the processes that it has started, which end with it. They are its
 * descendants; where the system shows the environments of processes, also those whose parents have
 * ended, by a variable that they inherit. A process that drops this variable is not found. Confined
 * to one thread, except {@link #close}.
 */
final class ProcessTree implements Unfinished {
  private static final String VARIABLE = "LUMBRE_PROGRAM";
  private static final Path PROCESSES = Path.of("/proc");

  /** A process that starts others while it is ended needs several rounds. */
  private static final int ROUNDS = 50;

  private static final long PAUSE_MILLIS = 10;

  private final Process process;
  private final String mark;
  private final Set<ProcessHandle> seen = new LinkedHashSet<>();

  private ProcessTree(Process process, String mark) {
    this.process = process;
    this.mark = mark;
  }

  /** Starts a program; the end of this process ends it, too. */
  static ProcessTree start(ProcessBuilder builder) throws IOException {
    String mark = System.nanoTime() + "-" + Thread.currentThread().getId();
    builder.environment().put(VARIABLE, mark);
    return ProcessEnd.add(new ProcessTree(builder.start(), VARIABLE + "=" + mark + '\0'));
  }

  Process process() {
    return process;
  }

  /** Looks for processes that have been started, before their parents end. */
  synchronized void look() {
    process.descendants().forEach(seen::add);
  }

  /** Ends all processes. */
  @Override
  public synchronized void close() {
    ProcessEnd.remove(this);
    Set<ProcessHandle> ended = new HashSet<>();
    for (int round = 0; round < ROUNDS; round++) {
      // What was ended before may still be listed; new ones have been started meanwhile.
      List<ProcessHandle> more = alive().filter(ended::add).toList();
      more.forEach(ProcessHandle::destroyForcibly);
      // Destroying an ended process would close what it said before it is read.
      if (process.isAlive()) {
        process.destroyForcibly();
      } else if (more.isEmpty()) {
        return;
      }
      pause();
    }
  }

  private static void pause() {
    try {
      Thread.sleep(PAUSE_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private Stream<ProcessHandle> alive() {
    look();
    return Stream.concat(seen.stream(), marked()).filter(ProcessHandle::isAlive);
  }

  private Stream<ProcessHandle> marked() {
    Stream.Builder<ProcessHandle> found = Stream.builder();
    try (DirectoryStream<Path> all = Files.newDirectoryStream(PROCESSES, "[0-9]*")) {
      for (Path each : all) {
        handle(each).filter(handle -> isMarked(each)).ifPresent(found::add);
      }
    } catch (IOException e) {
      // Other systems have no such folder.
      return Stream.empty();
    }
    return found.build();
  }

  private Optional<ProcessHandle> handle(Path folder) {
    long id = Long.parseLong(folder.getFileName().toString());
    return id == process.pid() ? Optional.empty() : ProcessHandle.of(id);
  }

  private boolean isMarked(Path folder) {
    try {
      byte[] environment = Files.readAllBytes(folder.resolve("environ"));
      return new String(environment, StandardCharsets.ISO_8859_1).contains(mark);
    } catch (IOException e) {
      // It has ended, or belongs to another user.
      return false;
    }
  }
}
