package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;

/** Starts other processes, as a user would, and waits for their end. */
final class Program {
  /** The jar of the command line with all its dependencies. */
  static final Path JAR = Path.of("target", "lumbre-all.jar").toAbsolutePath();

  /** The signals that end a render in a terminal, by their number. */
  private static final Map<Integer, String> SIGNALS = Map.of(1, "HUP", 2, "INT");

  private static final long PATIENCE_SECONDS = 60;

  private Program() {}

  /** Returns the arguments that run Lumbre with the Java of this JVM. */
  static List<String> lumbre(String... args) {
    List<String> command = new ArrayList<>(List.of(java("java"), "-Xmx512m", "-jar", "" + JAR));
    command.addAll(List.of(args));
    return command;
  }

  /** Returns the path of a program in the current JDK. */
  static String java(String name) {
    return Path.of(System.getProperty("java.home"), "bin", name).toString();
  }

  /** Copies the built program, and the measurements beside it, into a project. */
  static void copyJars(Path home) throws IOException {
    Path target = Files.createDirectories(home.resolve("target"));
    for (Path jar : List.of(JAR, JAR.resolveSibling("lumbre-lab.jar"))) {
      Files.copy(jar, target.resolve(jar.getFileName()));
    }
  }

  /** Copies what the launcher reads to a copy of the project. */
  static void copyOptions(Path home) throws IOException {
    Path folder = Files.createDirectories(home.resolve("src/main/jvm"));
    for (String name : List.of("options", "short-options", "check-options", "short.sh")) {
      Files.copy(Path.of("src/main/jvm", name), folder.resolve(name));
    }
  }

  /** Starts a program in a directory that receives its output. */
  static Process start(Path directory, List<String> command) throws IOException {
    return new ProcessBuilder(interruptible(command))
        .directory(directory.toFile())
        .redirectOutput(directory.resolve("out.txt").toFile())
        .redirectError(directory.resolve("err.txt").toFile())
        .start();
  }

  /**
   * Returns a command that handles SIGINT and SIGHUP even if this process ignores them: shells make
   * background processes ignore the first one, {@code nohup} the second, and children inherit that.
   */
  static List<String> interruptible(List<String> command) throws IOException {
    Path status = Path.of("/proc/self/status");
    if (!Files.exists(status)) {
      return command;
    }
    Optional<String> ignored =
        Files.readAllLines(status).stream().filter(line -> line.startsWith("SigIgn:")).findAny();
    long mask =
        ignored.map(line -> Long.parseUnsignedLong(line.substring(7).trim(), 16)).orElse(0L);
    String names =
        SIGNALS.entrySet().stream()
            .filter(signal -> (mask >> signal.getKey() - 1 & 1) == 1)
            .map(Map.Entry::getValue)
            .collect(Collectors.joining(","));
    if (names.isEmpty()) {
      return command;
    }
    List<String> all = new ArrayList<>(List.of("env", "--default-signal=" + names));
    all.addAll(command);
    return all;
  }

  /** Waits for the end of a process from {@link #start}. */
  static Outcome await(Path directory, Process process) throws IOException, InterruptedException {
    if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      throw new AssertionError("still running after " + PATIENCE_SECONDS + " s: " + process.info());
    }
    return new Outcome(
        process.exitValue(),
        Files.readString(directory.resolve("out.txt")),
        Files.readString(directory.resolve("err.txt")));
  }

  /** Runs a program in a directory. */
  static Outcome run(Path directory, List<String> command)
      throws IOException, InterruptedException {
    return await(directory, start(directory, command));
  }

  /** Sends a signal to a process. */
  static void send(String signal, Process process) throws IOException, InterruptedException {
    List<String> kill = List.of("kill", "-" + signal, "" + process.pid());
    assertThat(new ProcessBuilder(kill).start().waitFor()).isZero();
  }

  static void endAll(List<Process> started) throws InterruptedException {
    for (Process process : started) {
      process.destroyForcibly().waitFor();
    }
  }
}
