package io.github.lumbre.spark;

import io.github.lumbre.cli.Lumbre;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.image.internal.ImageFormat;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;

/**
 * The program for {@code spark-submit}: {@code RenderOnSpark SCENE... [OPTIONS]} renders scenes
 * with the options of {@code lumbre render}, and {@code RenderOnSpark resume FILM [OPTIONS]}
 * resumes a checkpoint. Without {@code spark.master} it runs on all cores of this machine.
 */
public final class RenderOnSpark {
  private static final String USAGE =
      """
      Render scenes on Apache Spark; pictures are bit-identical to those of one machine.
      Usage: lumbre-spark [--unit SECONDS] SCENE... [OPTIONS]
             lumbre-spark [--unit SECONDS] --list FILE [OPTIONS]
             lumbre-spark [--unit SECONDS] resume FILM [OPTIONS]
        --unit SECONDS  Time that a unit of work should take on one core (20s).
        --list FILE     Render the scenes that a text file names, one a line.
        OPTIONS         As in 'lumbre render' and 'lumbre resume'; with several scenes, -o names a
                        folder. --adaptive is not available. --checkpoint and FILM may be on a
                        Hadoop file system: hdfs://, s3a://, file:/.
      """;

  private static final int USAGE_CODE = 2;
  private static final int SCENE_CODE = 3;
  private static final int OUTPUT_CODE = 6;
  private static final int INTERNAL_CODE = 7;

  /** The number of pictures of a list that render at the same time. */
  static final int PICTURES_AT_ONCE = 4;

  private RenderOnSpark() {}

  /** Runs the program and exits with an exit code of {@code lumbre render}. */
  public static void main(String[] args) {
    Interruption.install();
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    int exitCode = run(List.of(args), out, err);
    System.exit(Interruption.exitCode(exitCode));
  }

  /** Runs the program and returns its exit code. */
  static int run(List<String> args, PrintWriter out, PrintWriter err) {
    Arguments arguments;
    try {
      arguments = Arguments.of(args);
    } catch (IllegalArgumentException e) {
      err.println("error: " + e.getMessage());
      err.print(USAGE);
      err.flush();
      return USAGE_CODE;
    } catch (IOException e) {
      err.println("error: --list: cannot be read: " + e.getMessage());
      return SCENE_CODE;
    }
    if (arguments.isHelp()) {
      out.print(USAGE);
      out.flush();
      return 0;
    }
    Optional<String> clash = arguments.clash();
    if (clash.isPresent()) {
      err.println("error: " + clash.get());
      return OUTPUT_CODE;
    }
    SparkConf conf = new SparkConf().setIfMissing("spark.master", "local[*]");
    conf.setIfMissing("spark.app.name", "Lumbre");
    conf.setIfMissing("spark.ui.showConsoleProgress", "false");
    try (JavaSparkContext spark = new JavaSparkContext(conf)) {
      SparkEngine engine = new SparkEngine(spark, arguments.unitSeconds(), err::println);
      if (arguments.commands().size() == 1) {
        return run(arguments.commands().get(0), spark, out, err, engine);
      }
      return runAll(arguments.commands(), spark, out, err, engine);
    }
  }

  /**
   * Renders several pictures at the same time, so that the units of one keep the cores busy that
   * the last units of another leave idle. Prints the messages of a picture when it is done.
   */
  private static int runAll(
      List<List<String>> commands,
      JavaSparkContext spark,
      PrintWriter out,
      PrintWriter err,
      SparkEngine engine) {
    ExecutorService pictures = Executors.newFixedThreadPool(PICTURES_AT_ONCE);
    try {
      List<Future<Integer>> codes = new ArrayList<>();
      for (List<String> command : commands) {
        codes.add(pictures.submit(() -> runQuietly(command, spark, out, err, engine)));
      }
      int exitCode = 0;
      for (Future<Integer> code : codes) {
        exitCode = Math.max(exitCode, code.get());
      }
      return exitCode;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return INTERNAL_CODE;
    } catch (ExecutionException e) {
      throw new IllegalStateException(e.getCause());
    } finally {
      pictures.shutdownNow();
    }
  }

  private static int runQuietly(
      List<String> command,
      JavaSparkContext spark,
      PrintWriter out,
      PrintWriter err,
      SparkEngine engine) {
    List<String> quiet = new ArrayList<>(command);
    if (quiet.stream().noneMatch(argument -> argument.startsWith("--progress"))) {
      // Bars of several pictures would overwrite each other.
      quiet.add("--progress=none");
    }
    StringWriter ownOut = new StringWriter();
    StringWriter ownErr = new StringWriter();
    int code = run(quiet, spark, new PrintWriter(ownOut), new PrintWriter(ownErr), engine);
    synchronized (RenderOnSpark.class) {
      out.print(ownOut);
      out.flush();
      err.print(ownErr);
      err.flush();
    }
    return code;
  }

  private static int run(
      List<String> command,
      JavaSparkContext spark,
      PrintWriter out,
      PrintWriter err,
      SparkEngine engine) {
    List<String> arguments = new ArrayList<>(command);
    Optional<RemoteCheckpoint> remote;
    try {
      remote = RemoteCheckpoint.of(arguments, spark.hadoopConfiguration(), err::println);
    } catch (IOException e) {
      err.println("error: " + e.getMessage());
      return command.get(0).equals("resume") ? SCENE_CODE : OUTPUT_CODE;
    }
    int code = Lumbre.run(arguments.toArray(String[]::new), out, err, engine);
    try {
      remote.ifPresent(RemoteCheckpoint::close);
    } catch (UncheckedIOException e) {
      err.println("error: " + e.getMessage() + ": " + e.getCause().getMessage());
      return OUTPUT_CODE;
    }
    return code;
  }

  /**
   * The arguments, taken apart.
   *
   * @param commands arguments of the command line, one list a picture
   */
  record Arguments(double unitSeconds, boolean isHelp, List<List<String>> commands) {
    private static final double UNIT_SECONDS = 20;

    static Arguments of(List<String> args) throws IOException {
      double unit = UNIT_SECONDS;
      List<String> scenes = new ArrayList<>();
      List<String> options = new ArrayList<>();
      for (int i = 0; i < args.size(); i++) {
        String arg = args.get(i);
        if (arg.equals("-h") || arg.equals("--help")) {
          return new Arguments(unit, true, List.of());
        } else if (arg.equals("--unit")) {
          unit = seconds(value(args, ++i, arg));
        } else if (arg.equals("--list")) {
          Path list = Path.of(value(args, ++i, arg));
          Files.readAllLines(list).stream()
              .map(String::strip)
              .filter(line -> !line.isEmpty())
              .forEach(scenes::add);
        } else if (arg.equals("--adaptive")) {
          throw new IllegalArgumentException(
              "--adaptive: not available on Spark, because the next samples depend on all pixels");
        } else if (arg.equals("--sheet") || arg.startsWith("--sheet=")) {
          throw new IllegalArgumentException(
              "--sheet: not available on Spark, where each scene is a command of its own");
        } else if (arg.startsWith("-") || !options.isEmpty()) {
          options.add(arg);
        } else {
          scenes.add(arg);
        }
      }
      if (scenes.isEmpty()) {
        throw new IllegalArgumentException("expected a scene, found none");
      }
      return new Arguments(unit, false, commands(scenes, options));
    }

    private static String value(List<String> args, int i, String flag) {
      if (i >= args.size()) {
        throw new IllegalArgumentException(flag + ": expected a value, found none");
      }
      return args.get(i);
    }

    private static double seconds(String text) {
      String number = text.endsWith("s") ? text.substring(0, text.length() - 1) : text;
      try {
        double seconds = Double.parseDouble(number);
        if (seconds >= .1 && seconds <= 3600) {
          return seconds;
        }
      } catch (NumberFormatException e) {
        // Reported below.
      }
      throw new IllegalArgumentException("--unit: expected 0.1s to 3600s, found " + text);
    }

    private static List<List<String>> commands(List<String> scenes, List<String> options) {
      if (scenes.get(0).equals("resume") && scenes.size() == 2) {
        List<String> command = new ArrayList<>(scenes);
        command.addAll(options);
        return List.of(command);
      }
      if (scenes.size() > 1) {
        output(options).ifPresent(Arguments::requireFolder);
        if (options.stream().anyMatch(option -> option.matches("--checkpoint(=.*)?"))) {
          throw new IllegalArgumentException(
              "--checkpoint: requires one scene, found " + scenes.size());
        }
      }
      List<List<String>> commands = new ArrayList<>();
      for (String scene : scenes) {
        List<String> command = new ArrayList<>(List.of("render", scene));
        command.addAll(options);
        commands.add(command);
      }
      return commands;
    }

    /** Returns the value of {@code -o}, which the command line takes in five forms. */
    private static Optional<String> output(List<String> options) {
      Optional<String> output = Optional.empty();
      for (int i = 0; i < options.size(); i++) {
        String option = options.get(i);
        if (option.equals("-o") || option.equals("--output")) {
          output = i + 1 < options.size() ? Optional.of(options.get(++i)) : Optional.empty();
        } else if (option.startsWith("--output=") || option.matches("-o.+")) {
          output = Optional.of(option.replaceFirst("--output=|-o=?", ""));
        }
      }
      return output;
    }

    private static void requireFolder(String output) {
      if (!PictureOutput.isFolder(Path.of(output))) {
        throw new IllegalArgumentException(
            "-o: expected a folder for the pictures of several scenes, which exists or has a name"
                + " without an ending, found "
                + output
                + "; only frames of one model are joined on Spark");
      }
    }

    /** Returns the message about two scenes with the same picture; empty if there are none. */
    Optional<String> clash() {
      if (commands.size() == 1) {
        return Optional.empty();
      }
      List<Path> scenes = commands.stream().map(command -> Path.of(command.get(1))).toList();
      return PictureOutput.clash(scenes, s -> PictureOutput.defaultFor(s, ImageFormat.PNG));
    }
  }
}
