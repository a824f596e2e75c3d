package io.github.lumbre.mutants;

import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Plants each of the described defects in a copy of the classes and runs the tests that should find
 * it. Ends with 1 if one of them survives or cannot be planted, or if a test fails without any.
 */
public final class Mutants {
  private static final String VECTORS = "jdk.incubator.vector";
  private static final String PACKAGE = "io/github/lumbre";

  /** What a defect may take to be found, in seconds: an endless loop is not a good answer. */
  private static final int PATIENCE = 600;

  private final Path descriptions;
  private final Path sources;
  private final Path work;
  private final Pattern include;
  private final PrintStream out;

  /** What became of a defect. */
  private record Outcome(String name, boolean isKilled, String reason, double seconds) {}

  private Mutants(Path descriptions, Path sources, Path work, Pattern include, PrintStream out) {
    this.descriptions = descriptions;
    this.sources = sources;
    this.work = work;
    this.include = include;
    this.out = out;
  }

  /**
   * Plants defects.
   *
   * @param arguments the folder of descriptions, the root folder of the sources, a folder to work
   *     in, and a regular expression that the names of those to be planted contain
   */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    boolean allKilled =
        new Mutants(
                Path.of(arguments[0]),
                Path.of(arguments[1]),
                Path.of(arguments[2]),
                Pattern.compile(arguments[3]),
                System.out)
            .run();
    System.exit(allKilled ? 0 : 1);
  }

  private boolean run() throws IOException, InterruptedException {
    long start = System.nanoTime();
    List<Outcome> outcomes = plantAll(read());
    long alive = outcomes.stream().filter(outcome -> !outcome.isKilled()).count();
    out.printf(
        "%d defects, %d killed, %d not; %.0f s%n",
        outcomes.size(), outcomes.size() - alive, alive, (System.nanoTime() - start) * 1e-9);
    return alive == 0 && passWithoutDefects(outcomes);
  }

  /** Sees to it that the tests that failed do so because of the defects. */
  private boolean passWithoutDefects(List<Outcome> outcomes)
      throws IOException, InterruptedException {
    TreeSet<String> tests = new TreeSet<>();
    outcomes.forEach(outcome -> tests.add(outcome.reason().split(":")[0]));
    Outcome sane = runTests("no defect", "", tests.toArray(String[]::new));
    if (!sane.reason().isEmpty()) {
      out.println("A test fails without any defect: " + sane.reason());
      return false;
    }
    out.printf("The %d tests that failed pass without (%.0f s).%n", tests.size(), sane.seconds());
    return true;
  }

  private List<Mutant> read() throws IOException {
    List<Mutant> mutants = new ArrayList<>();
    try (Stream<Path> files = Files.list(descriptions)) {
      for (Path file : files.filter(f -> f.toString().endsWith(Mutant.ENDING)).sorted().toList()) {
        if (include.matcher(file.getFileName().toString()).find()) {
          mutants.add(readOne(file));
        }
      }
    }
    return mutants;
  }

  private static Mutant readOne(Path file) throws IOException {
    try {
      return Mutant.read(file);
    } catch (MutantException e) {
      throw new IOException(file + ": " + e.getMessage(), e);
    }
  }

  private List<Outcome> plantAll(List<Mutant> mutants) throws InterruptedException {
    ExecutorService pool = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
    try {
      List<Future<Outcome>> futures = new ArrayList<>();
      for (Mutant mutant : mutants) {
        futures.add(pool.submit(() -> plant(mutant)));
      }
      List<Outcome> outcomes = new ArrayList<>();
      for (Future<Outcome> future : futures) {
        Outcome outcome = future.get();
        out.printf(
            "%-8s %4.1f s  %s: %s%n",
            outcome.isKilled() ? "killed" : "ALIVE",
            outcome.seconds(),
            outcome.name(),
            outcome.reason());
        outcomes.add(outcome);
      }
      return outcomes;
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    } finally {
      pool.shutdownNow();
    }
  }

  private Outcome plant(Mutant mutant) throws IOException, InterruptedException {
    Path folder = work.resolve(mutant.name());
    try {
      compile(mutant, folder);
    } catch (MutantException e) {
      return new Outcome(mutant.name(), false, "cannot be planted: " + e.getMessage(), 0);
    }
    String classes = folder.resolve("classes") + File.pathSeparator;
    Outcome outcome = runTests(mutant.name(), classes, mutant.tests().toArray(String[]::new));
    return outcome.reason().isEmpty()
        ? new Outcome(mutant.name(), false, "found by no test", outcome.seconds())
        : outcome;
  }

  /** Compiles the changed sources alone, against the classes as they are. */
  private void compile(Mutant mutant, Path folder) throws IOException, MutantException {
    delete(folder);
    Path changed = folder.resolve("sources");
    TreeSet<Path> files = new TreeSet<>();
    for (Edit edit : mutant.edits()) {
      Path target = changed.resolve(PACKAGE).resolve(edit.file());
      Path source = files.contains(target) ? target : sources.resolve(PACKAGE).resolve(edit.file());
      List<String> lines = edit.applyTo(Files.readAllLines(source));
      Files.createDirectories(target.getParent());
      Files.write(target, lines);
      files.add(target);
    }
    Path classes = Files.createDirectories(folder.resolve("classes"));
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter messages = new StringWriter();
    List<String> options =
        List.of(
            "-d", classes.toString(), "-cp", classPath(), "--add-modules", VECTORS, "-proc:none");
    try (StandardJavaFileManager manager =
        compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
      boolean done =
          compiler
              .getTask(
                  messages,
                  manager,
                  null,
                  options,
                  null,
                  manager.getJavaFileObjectsFromPaths(files))
              .call();
      if (!done) {
        throw new MutantException("it does not compile:\n" + messages);
      }
    }
  }

  /** Deletes what an earlier run left. */
  private static void delete(Path folder) throws IOException {
    if (Files.exists(folder)) {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }

  /** Runs tests in a process of their own; a reason is given if one fails. */
  private Outcome runTests(String name, String classes, String... tests)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-ea", "-XX:+UseSerialGC"));
    command.addAll(List.of("-Djava.awt.headless=true", "--add-modules", VECTORS));
    command.addAll(List.of("-cp", classes + classPath(), NamedTests.class.getName()));
    command.addAll(List.of(tests));
    Path log = Files.createDirectories(work).resolve(name.replace(' ', '-') + ".log");
    long start = System.nanoTime();
    Process process =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile()).start();
    boolean ended = process.waitFor(PATIENCE, TimeUnit.SECONDS);
    process.destroyForcibly();
    double seconds = (System.nanoTime() - start) * 1e-9;
    if (!ended) {
      return new Outcome(name, false, "no answer after " + PATIENCE + " s", seconds);
    }
    List<String> lines = Files.readAllLines(log);
    String last = lines.isEmpty() ? "" : lines.get(lines.size() - 1);
    return switch (process.exitValue()) {
      case NamedTests.PASSED -> new Outcome(name, true, "", seconds);
      case NamedTests.FAILED -> new Outcome(name, true, last, seconds);
      default -> new Outcome(name, false, process.exitValue() + ": " + last, seconds);
    };
  }

  private static String classPath() {
    return System.getProperty("java.class.path");
  }
}
