package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.assertj.core.api.SoftAssertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Holds what a short command loads and compiles, which is most of its time. {@code ./mvnw test
 * -Dtest=StartCostTest -Dlumbre.write=true} measures nine runs of each command with the Java of
 * Maven, and stores their medians beside those of other versions of Java.
 */
class StartCostTest {
  private static final Path BOUNDS = Path.of("src", "test", "resources", "start-costs.csv");
  private static final String HEAD =
      "command,Java,own classes,Java's classes,generated classes,methods of the fast compiler,its"
          + " bytes,methods of the optimizing compiler,its bytes";
  private static final int JAVA = Runtime.version().feature();

  private static final String MODEL = file("src/main/jvm/rehearsal.gltf");
  private static final Map<String, List<String>> COMMANDS = new LinkedHashMap<>();

  static {
    COMMANDS.put("check", List.of("check", MODEL));
    COMMANDS.put("thumbnail", render(MODEL, "256x192", 2));
    COMMANDS.put("scene", render(file("scenes/cornell-box.json"), "160x120", 4));
  }

  @TempDir private Path directory;

  private static String file(String name) {
    return Path.of(name).toAbsolutePath().toString();
  }

  private static List<String> render(String file, String size, int samples) {
    String[] rest = {"-s", "" + samples, "--progress", "none", "--overwrite", "-o", "a.png"};
    return Stream.concat(Stream.of("render", file, "--size", size), Stream.of(rest)).toList();
  }

  static List<String> commands() {
    return List.copyOf(COMMANDS.keySet());
  }

  private List<StartCost> costs(String command, int runs) throws IOException, InterruptedException {
    List<StartCost> costs = new ArrayList<>();
    for (int i = 0; i < runs; i++) {
      costs.add(StartCost.of(directory, COMMANDS.get(command)));
    }
    return costs;
  }

  /** Returns the stored numbers by command and version of Java. */
  private static Map<String, StartCost> stored() throws IOException {
    return Files.readAllLines(BOUNDS).stream()
        .skip(1)
        .map(line -> line.split(","))
        .collect(
            Collectors.toMap(
                cells -> cells[0] + "," + cells[1],
                cells ->
                    StartCost.of(
                        Arrays.stream(cells).skip(2).mapToInt(Integer::parseInt).toArray()),
                (a, b) -> b,
                LinkedHashMap::new));
  }

  @ParameterizedTest
  @MethodSource("commands")
  void commandsLoadAndCompileNoMoreThanTheyDid(String command) throws Exception {
    Map<String, StartCost> stored = stored();
    if (Boolean.getBoolean("lumbre.write")) {
      stored.put(command + "," + JAVA, StartCost.median(costs(command, 9)));
      store(stored);
    }
    StartCost bound = stored.get(command + "," + JAVA);
    assumeTrue(bound != null, "no numbers are stored for Java " + JAVA);
    StartCost cost = StartCost.median(costs(command, 3));
    SoftAssertions.assertSoftly(
        softly -> {
          softly.assertThat(cost.own()).as("own classes").isLessThanOrEqualTo(bound.own());
          // Updates of Java differ by a few.
          softly.assertThat(cost.java()).as("Java's classes").isLessThan(bound.java() * 51 / 50);
          softly
              .assertThat(cost.generated())
              .as("generated classes")
              .isLessThan(bound.generated() * 51 / 50);
          // What is compiled varies from run to run by a tenth, and with the load of the machine.
          for (int i = 3; i < 7; i++) {
            softly
                .assertThat(cost.numbers()[i])
                .as(HEAD.split(",")[i + 2])
                .isLessThan((int) (1.3 * bound.numbers()[i]));
          }
        });
  }

  /** The versions of Java that most users have; both start the same classes of Lumbre. */
  @Test
  void eachCommandHasNumbersOfTwoVersions() throws IOException {
    Map<String, StartCost> stored = stored();
    for (String command : commands()) {
      assertThat(stored).containsKeys(command + ",17", command + ",25");
      assertThat(stored.get(command + ",17").own()).isEqualTo(stored.get(command + ",25").own());
    }
  }

  private static void store(Map<String, StartCost> costs) throws IOException {
    List<String> lines = new ArrayList<>(List.of(HEAD));
    costs.forEach(
        (key, cost) ->
            lines.add(
                key
                    + ","
                    + IntStream.of(cost.numbers())
                        .mapToObj(String::valueOf)
                        .collect(Collectors.joining(","))));
    Files.write(BOUNDS, lines);
  }
}
