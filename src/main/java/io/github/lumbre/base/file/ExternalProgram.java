package io.github.lumbre.base.file;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Runs an installed program to its end, within a time limit and without a shell.
 *
 * @param path absolute path of the program
 * @param limit time after which it is ended
 */
public record ExternalProgram(Path path, Duration limit) {
  private static final Duration USUAL_LIMIT = Duration.ofMinutes(10);
  private static final int MAX_LOG = 1 << 16;
  private static final int LINES = 3;
  private static final int SHOWN = 300;

  /** The time between two looks at what a program does. */
  private static final long LOOK_MILLIS = 100;

  /** Writes the input of a program. */
  @FunctionalInterface
  public interface Input {
    Input NONE = out -> {};

    /** Writes all to a stream, which the caller closes. Called by a thread of its own. */
    void writeTo(OutputStream out) throws IOException;
  }

  /**
   * Where a program works, and how much it may write.
   *
   * @param folder in which it starts
   * @param output private folder for what it writes, its temporary files included
   * @param most bytes in that folder
   */
  public record Place(Path folder, PrivateFolder output, long most) {
    private boolean isFull() throws IOException {
      return output.bytes(most) > most;
    }
  }

  /** A program took too long, or wrote too much. */
  public static final class LimitException extends IOException {
    private static final long serialVersionUID = 1;

    LimitException(String message) {
      super(message);
    }
  }

  /**
   * Returns an installed program with a time limit of 10 minutes.
   *
   * @param name of the program
   * @param chosen path of the program or of its folder; if empty, a variable of the environment
   *     states it, or else the program is sought in the folders of {@code PATH}
   * @param variable name of the variable
   * @param advice how to get the program
   * @throws IOException if the program is not found
   */
  public static ExternalProgram find(
      String name,
      Optional<Path> chosen,
      String variable,
      Map<String, String> environment,
      String advice)
      throws IOException {
    Optional<Path> named =
        chosen.or(
            () ->
                Optional.ofNullable(environment.get(variable))
                    .filter(text -> !text.isBlank())
                    .map(Path::of));
    List<Path> places = named.map(List::of).orElse(onPath(environment.getOrDefault("PATH", "")));
    for (Path place : places) {
      for (Path file : List.of(place, place.resolve(name), place.resolve(name + ".exe"))) {
        if (Files.isRegularFile(file) && Files.isExecutable(file)) {
          return new ExternalProgram(file.toAbsolutePath(), USUAL_LIMIT);
        }
      }
    }
    String found =
        named.map(file -> file + ": not a program").orElse(name + ": not found on the PATH");
    throw new IOException(found + "; " + advice + "; or state its path in " + variable);
  }

  private static List<Path> onPath(String path) {
    return Stream.of(path.split(Pattern.quote(File.pathSeparator)))
        .filter(folder -> !folder.isBlank())
        .flatMap(folder -> expressible(folder).stream())
        .toList();
  }

  /** Returns a folder; empty if the locale's encoding cannot express its name. */
  private static Optional<Path> expressible(String folder) {
    try {
      return Optional.of(Path.of(folder));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  /** Returns the program with another time limit. */
  public ExternalProgram within(Duration each) {
    return new ExternalProgram(path, each);
  }

  /**
   * Runs the program and returns the start of its output. All processes that it has started end
   * with it.
   *
   * @throws IOException if the program does not start, takes too long, or fails, or if the input
   *     cannot be written to its end
   * @throws InterruptedException if the thread is interrupted; the program is ended
   */
  public String run(List<String> arguments, Input input) throws IOException, InterruptedException {
    return run(arguments, input, Optional.empty());
  }

  /** Runs the program without input in a place; see {@link #run(List, Input)}. */
  public String run(List<String> arguments, Place place) throws IOException, InterruptedException {
    return run(arguments, Input.NONE, Optional.of(place));
  }

  private String run(List<String> arguments, Input input, Optional<Place> place)
      throws IOException, InterruptedException {
    ProcessTree tree = start(arguments, place);
    Process process = tree.process();
    FutureTask<String> said = inBackground("listening to ", () -> said(process.getInputStream()));
    FutureTask<Void> fed =
        inBackground(
            "writing to ",
            () -> {
              try (OutputStream out = process.getOutputStream()) {
                input.writeTo(out);
              }
              return null;
            });
    try (tree) {
      await(tree, place);
    }
    String text = text(said);
    if (process.exitValue() != 0) {
      throw new IOException(path + ": failed with code " + process.exitValue() + lastLines(text));
    }
    requireDone(fed, text);
    return text;
  }

  /** Waits for the end of the program. */
  private void await(ProcessTree tree, Optional<Place> place)
      throws IOException, InterruptedException {
    long start = System.nanoTime();
    while (true) {
      long left = limit.minusNanos(System.nanoTime() - start).toMillis();
      if (tree.process().waitFor(Math.min(LOOK_MILLIS, left), TimeUnit.MILLISECONDS)) {
        return;
      }
      if (left <= 0) {
        throw new LimitException(
            path + ": took longer than " + limit.toMillis() / 1000.0 + " s and was ended");
      }
      tree.look();
      if (place.isPresent() && place.get().isFull()) {
        throw excess(place.get().most);
      }
    }
  }

  /** Returns the exception for a program that wrote too much. */
  public LimitException excess(long most) {
    return new LimitException(path + ": wrote more than " + most + " bytes and was ended");
  }

  private ProcessTree start(List<String> arguments, Optional<Place> place) throws IOException {
    List<String> command = new ArrayList<>(List.of(path.toString()));
    command.addAll(arguments);
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    place.ifPresent(
        where -> {
          builder.directory(where.folder.toFile());
          for (String variable : List.of("TMPDIR", "TEMP", "TMP")) {
            builder.environment().put(variable, where.output.path().toString());
          }
        });
    try {
      return ProcessTree.start(builder);
    } catch (IOException e) {
      throw new IOException(path + ": does not start: " + e.getMessage(), e);
    }
  }

  private <T> FutureTask<T> inBackground(String purpose, Callable<T> action) {
    FutureTask<T> task = new FutureTask<>(action);
    Thread thread = new Thread(task, purpose + path.getFileName());
    thread.setDaemon(true);
    thread.start();
    return task;
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
  private static String text(FutureTask<String> said) throws InterruptedException {
    try {
      return said.get(1, TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      return "";
    }
  }

  private void requireDone(FutureTask<Void> fed, String said)
      throws IOException, InterruptedException {
    try {
      fed.get(1, TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      throw new IOException(path + ": ended before it had read its input" + lastLines(said), e);
    } catch (ExecutionException e) {
      throw new IOException(e.getCause().getMessage(), e);
    }
  }

  /**
   * Returns the last lines of the output as one line, after a colon; nothing if there are none. The
   * first of them is often the reason.
   */
  public static String lastLines(String said) {
    List<String> lines = said.lines().map(String::strip).filter(line -> !line.isEmpty()).toList();
    String last = String.join("; ", lines.subList(Math.max(0, lines.size() - LINES), lines.size()));
    String shown = last.substring(0, Math.min(SHOWN, last.length())).replaceAll("\\p{Cntrl}", " ");
    return shown.isEmpty() ? "" : ": " + shown;
  }
}
