package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/**
 * What restructuring must not change: the pictures, films, scenes, texts, errors and exit codes of
 * many commands and calls, which {@code sheet-commands.txt} lists, have the stored hashes. If they
 * change for a reason, {@code ./mvnw test -Dtest=SheetOfHashesTest -Dlumbre.write=true} stores the
 * new ones.
 */
class SheetOfHashesTest {
  private static final Path RESOURCES = Path.of("src", "test", "resources");
  private static final Path COMMANDS = RESOURCES.resolve("sheet-commands.txt");
  private static final Path STORED = RESOURCES.resolve("sheet-hashes.csv");
  private static final String HEADER = "name,output,hash or exit codes";

  /** Names of rows, separated by commas, if not all are to run, as on an emulated processor. */
  private static final List<String> CHOSEN =
      List.of(System.getProperty("lumbre.sheet.rows", "").split(","));

  /** The largest number of characters of a changed text that are printed. */
  private static final int SHOWN = 1000;

  /** The models, and what each command wrote, in folders of their own. */
  @TempDir private Path directory;

  /** A line of the table. */
  private record Row(String name, String commands) {
    static Row of(String line) {
      String[] parts = line.split(" +\\| ", 2);
      return new Row(parts[0], parts[1]);
    }
  }

  private static List<Row> rows() throws IOException {
    return Files.readAllLines(COMMANDS).stream()
        .filter(line -> !line.isEmpty() && !line.startsWith("#"))
        .map(Row::of)
        .filter(row -> isChosen(row.name()))
        .toList();
  }

  private static boolean isChosen(String row) {
    return CHOSEN.contains("") || CHOSEN.contains(row);
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "messages name paths")
  void outputsAreAsBefore() throws Exception {
    Map<String, String> found = new LinkedHashMap<>();
    Map<String, String> texts = new HashMap<>();
    for (Row row : rows()) {
      Path folder = Files.createDirectory(directory.resolve(row.name().replace(' ', '-')));
      try (SheetRun run = SheetRun.in(folder)) {
        run.outputs(row.commands())
            .forEach((output, content) -> keep(row.name() + "," + output, content, found, texts));
      }
    }
    if (Boolean.getBoolean("lumbre.write")) {
      store(found);
    }
    assertThat(changes(stored(), found, texts))
        .as("outputs that changed; if that is meant, store them with -Dlumbre.write=true")
        .isEmpty();
  }

  private static void keep(
      String key, byte[] content, Map<String, String> found, Map<String, String> texts) {
    String text = new String(content, StandardCharsets.UTF_8);
    found.put(key, key.endsWith(",exit") ? text : SteadyBytes.hash(content));
    texts.put(key, text);
  }

  @Test
  void everyFlagOfAModelIsUsed() throws IOException {
    String commands = Files.readString(COMMANDS);
    CommandSpec flags = new CommandLine(new SheetRun.Staged()).getCommandSpec();
    assertThat(flags.options())
        .extracting(option -> option.longestName())
        .allSatisfy(flag -> assertThat(commands).contains(" " + flag + " "));
  }

  @Test
  void changesAreNamed() {
    Map<String, String> before = Map.of("a,exit", "1", "a,b.png", "2", "c,exit", "3");
    Map<String, String> now = Map.of("a,exit", "1", "a,b.png", "4", "d,out", "5");
    assertThat(changes(before, now, Map.of("d,out", "printed")))
        .containsExactly(
            "a,b.png: expected 2, found 4",
            "c,exit: expected 3, found nothing",
            "d,out: expected nothing, found 5: printed");
  }

  private static List<String> changes(
      Map<String, String> before, Map<String, String> now, Map<String, String> texts) {
    TreeSet<String> keys = new TreeSet<>(before.keySet());
    keys.addAll(now.keySet());
    return keys.stream()
        .filter(key -> !before.getOrDefault(key, "").equals(now.get(key)))
        .map(
            key ->
                key
                    + ": expected "
                    + before.getOrDefault(key, "nothing")
                    + ", found "
                    + now.getOrDefault(key, "nothing")
                    + shown(key, texts))
        .toList();
  }

  private static String shown(String key, Map<String, String> texts) {
    String text = texts.getOrDefault(key, "");
    boolean isPrinted = !text.isEmpty() && key.matches(".*(,out|,err|\\.json)");
    return isPrinted ? ": " + text.substring(0, Math.min(text.length(), SHOWN)) : "";
  }

  private static Map<String, String> stored() throws IOException {
    return Files.readAllLines(STORED).stream()
        .skip(1)
        .filter(line -> isChosen(line.substring(0, line.indexOf(','))))
        .collect(
            Collectors.toMap(
                line -> line.substring(0, line.lastIndexOf(',')),
                line -> line.substring(line.lastIndexOf(',') + 1)));
  }

  private static void store(Map<String, String> found) throws IOException {
    Stream<String> lines =
        found.entrySet().stream().map(output -> output.getKey() + "," + output.getValue());
    Files.writeString(
        STORED,
        Stream.concat(Stream.of(HEADER), lines)
            .map(line -> line + "\n")
            .collect(Collectors.joining()));
  }
}
