package io.github.lumbre.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * What a command makes Java load and compile, as numbers that need no clock.
 *
 * @param own classes of Lumbre and its libraries, which are the same at each start
 * @param java classes of Java itself
 * @param generated classes that Java makes at run time, such as those of lambdas
 * @param fastMethods methods that the fast compiler compiles
 * @param fastBytes bytes of their code
 * @param optimizedMethods methods that the optimizing compiler compiles
 * @param optimizedBytes bytes of their code
 */
record StartCost(
    int own,
    int java,
    int generated,
    int fastMethods,
    int fastBytes,
    int optimizedMethods,
    int optimizedBytes) {
  private static final Pattern CLASS = Pattern.compile("\\] (\\S+) source: ");
  private static final Pattern OWN =
      Pattern.compile("(io\\.github\\.lumbre|picocli|com\\.google)\\..*");
  private static final Pattern GENERATED =
      Pattern.compile(
          ".*(\\$\\$Lambda|LambdaForm\\$|\\$Proxy|\\$Species_|\\.Generated\\w+Accessor).*");
  private static final Pattern METHOD =
      Pattern.compile("\\] +\\d+ [%sb!n ]*([1-4]) +\\S+(?: @ -?\\d+)? +\\((\\d+) bytes\\) *");

  /** The tier of the optimizing compiler. */
  private static final int OPTIMIZED = 4;

  /**
   * Runs a command in a Java virtual machine of its own, as the launchers do but without an archive
   * of classes and without vectors, which not every processor has.
   */
  static StartCost of(Path directory, List<String> arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(Program.java("java")));
    command.add("@" + Path.of("src", "main", "jvm", "options").toAbsolutePath());
    command.add("-XX:ActiveProcessorCount=2");
    command.add("-Xlog:class+load:file=classes.txt::filecount=0");
    command.add("-Xlog:jit+compilation=debug:file=methods.txt::filecount=0");
    command.addAll(List.of("-cp", classPath(), Main.class.getName()));
    command.addAll(arguments);
    Program.run(directory, command).done();
    return of(
        Files.readAllLines(directory.resolve("classes.txt")),
        Files.readAllLines(directory.resolve("methods.txt")));
  }

  private static String classPath() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
        .map(entry -> Path.of(entry).toAbsolutePath().toString())
        .collect(Collectors.joining(File.pathSeparator));
  }

  private static StartCost of(List<String> loaded, List<String> compiled) {
    int[] classes = new int[3];
    for (String line : loaded) {
      Matcher found = CLASS.matcher(line);
      if (found.find()) {
        String name = found.group(1);
        boolean isOwn = OWN.matcher(name).matches();
        classes[GENERATED.matcher(name).matches() ? 2 : isOwn ? 0 : 1]++;
      }
    }
    int[] methods = new int[4];
    for (String line : compiled) {
      Matcher found = METHOD.matcher(line);
      if (found.find()) {
        int first = Integer.parseInt(found.group(1)) == OPTIMIZED ? 2 : 0;
        methods[first]++;
        methods[first + 1] += Integer.parseInt(found.group(2));
      }
    }
    return new StartCost(
        classes[0], classes[1], classes[2], methods[0], methods[1], methods[2], methods[3]);
  }

  /** Returns the median of each number. */
  static StartCost median(List<StartCost> costs) {
    return of(IntStream.range(0, 7).map(i -> median(costs, i)).toArray());
  }

  private static int median(List<StartCost> costs, int number) {
    int[] sorted = costs.stream().mapToInt(cost -> cost.numbers()[number]).sorted().toArray();
    return sorted[sorted.length / 2];
  }

  static StartCost of(int... numbers) {
    return new StartCost(
        numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6]);
  }

  int[] numbers() {
    return new int[] {
      own, java, generated, fastMethods, fastBytes, optimizedMethods, optimizedBytes
    };
  }
}
