package io.github.lumbre.models;

import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Every model and every sky in other people's packages loads, or is refused with a reason, as
 * {@code real-models.tsv} lists it. The results are in {@code target/models/table.md}, and those in
 * the form of the list in {@code target/models/real-models.tsv}.
 */
@Tag("models")
class RealModelsTest {
  private static final int PATIENCE_SECONDS = 60;

  private static final String LIST = "real-models.tsv";

  private static final List<Row> ROWS = new ArrayList<>();

  /** The sources that cannot be fetched, with the reasons. */
  private static final Map<ModelSource, String> NOT_FETCHED = new EnumMap<>(ModelSource.class);

  /** How the reading of a file ended. */
  private enum Result {
    LOADED,
    REFUSED,
    FAILED
  }

  /** What was read from a file: its triangles or pixels, and its warnings. */
  private record Content(long size, List<String> warnings) {}

  private record Row(
      ModelSource source, Path file, Result result, long size, double seconds, String text) {
    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "| %s | %s | %s | %.2f | %s | %s |",
          source.folder().relativize(file),
          ModelSource.ending(file),
          result == Result.LOADED ? Long.toString(size) : "",
          seconds,
          result.name().toLowerCase(Locale.ROOT),
          oneLine(text).replace("|", "\\|"));
    }

    /** Returns this row in the form of the list; warnings are not part of it. */
    String line() {
      String reason = result == Result.LOADED ? Long.toString(size) : oneLine(text);
      String end = result.name().toLowerCase(Locale.ROOT) + "\t" + reason;
      String path = source.folder().relativize(file).toString().replace('\\', '/');
      return source.label() + "\t" + path + "\t" + end;
    }
  }

  static List<ModelSource> sources() {
    return ModelSource.selected();
  }

  @ParameterizedTest
  @MethodSource("sources")
  void everyFileLoadsOrIsRefusedAsListed(ModelSource source) throws Exception {
    List<Path> files;
    try {
      files = source.fetch();
    } catch (AssertionError e) {
      NOT_FETCHED.put(source, oneLine(e.getMessage()));
      throw e;
    }
    List<String> failures = new ArrayList<>();
    for (Path file : files) {
      Row row = row(source, file);
      ROWS.add(row);
      if (row.result() == Result.FAILED) {
        failures.add(row.file() + ": " + row.text());
      }
    }
    assertThat(failures).isEmpty();
    List<String> found =
        ROWS.stream().filter(row -> row.source() == source).map(Row::line).toList();
    List<String> listed = listed(source);
    assertThat(without(listed, found)).as("lines of " + LIST + " that no longer hold").isEmpty();
    assertThat(without(found, listed)).as("results that " + LIST + " lacks").isEmpty();
  }

  /** Returns the expected results of a source. */
  private static List<String> listed(ModelSource source) throws IOException {
    try (InputStream in = RealModelsTest.class.getResourceAsStream(LIST)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> line.startsWith(source.label() + "\t"))
          .toList();
    }
  }

  private static List<String> without(List<String> all, List<String> others) {
    Set<String> known = Set.copyOf(others);
    return all.stream().filter(line -> !known.contains(line)).toList();
  }

  private static String oneLine(String text) {
    return text.replaceAll("\\s+", " ");
  }

  @AfterAll
  static void writeTable() throws IOException {
    Files.createDirectories(ModelSource.ROOT);
    Files.write(ModelSource.ROOT.resolve("table.md"), table());
    Files.write(ModelSource.ROOT.resolve(LIST), ROWS.stream().map(Row::line).toList());
  }

  private static List<String> table() {
    List<String> lines = new ArrayList<>();
    lines.add("| source | files | loaded | with warnings | refused | failed | triangles | s |");
    lines.add("|---|--:|--:|--:|--:|--:|--:|--:|");
    for (ModelSource source : ModelSource.selected()) {
      List<Row> rows = ROWS.stream().filter(row -> row.source() == source).toList();
      lines.add(
          String.format(
              Locale.ROOT,
              "| %s | %d | %d | %d | %d | %d | %d | %.0f |",
              source.origin(),
              rows.size(),
              count(rows, Result.LOADED),
              rows.stream()
                  .filter(row -> row.result() == Result.LOADED && !row.text().isEmpty())
                  .count(),
              count(rows, Result.REFUSED),
              count(rows, Result.FAILED),
              rows.stream()
                  .filter(row -> ModelSource.isModel(row.file()))
                  .mapToLong(Row::size)
                  .sum(),
              rows.stream().mapToDouble(Row::seconds).sum()));
    }
    lines.add("");
    lines.add("| files | refused or warned of |");
    lines.add("|--:|---|");
    kinds().forEach((kind, number) -> lines.add("| " + number + " | " + kind + " |"));
    for (ModelSource source : ModelSource.selected()) {
      lines.add("");
      lines.add("## " + source.origin());
      if (NOT_FETCHED.containsKey(source)) {
        lines.add("not fetched: " + NOT_FETCHED.get(source));
        continue;
      }
      lines.add("| file | format | triangles or pixels | s | result | reason or warnings |");
      lines.add("|---|---|--:|--:|---|---|");
      ROWS.stream().filter(row -> row.source() == source).map(Row::toString).forEach(lines::add);
    }
    return lines;
  }

  private static long count(List<Row> rows, Result result) {
    return rows.stream().filter(row -> row.result() == result).count();
  }

  /** Returns the numbers of files by message, without the names and numbers in the messages. */
  private static Map<String, Integer> kinds() {
    Map<String, Integer> kinds = new TreeMap<>();
    for (Row row : ROWS) {
      if (!row.text().isEmpty()) {
        String kind =
            row.text()
                .replaceAll("(\"[^\"]*\")", "NAME")
                .replaceAll("[0-9][0-9,]*", "N")
                .replace("|", "\\|");
        kinds.merge(row.result().name().toLowerCase(Locale.ROOT) + ": " + kind, 1, Integer::sum);
      }
    }
    return kinds;
  }

  /** Reads a file in a thread of its own, so that a reader that hangs is noticed. */
  private static Row row(ModelSource source, Path file) throws InterruptedException {
    FutureTask<Content> task =
        new FutureTask<>(() -> ModelSource.isModel(file) ? model(file) : sky(file));
    Thread thread = new Thread(task, "reader of " + file);
    thread.setDaemon(true);
    long start = System.nanoTime();
    thread.start();
    Result result = Result.LOADED;
    long size = 0;
    String text;
    try {
      Content content = task.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
      size = content.size();
      text = content.warnings().stream().limit(1).collect(joining());
    } catch (TimeoutException e) {
      task.cancel(true);
      result = Result.FAILED;
      text = "not finished after " + PATIENCE_SECONDS + " s";
    } catch (ExecutionException e) {
      text = reason(file, e.getCause());
      result = text.isEmpty() ? Result.FAILED : Result.REFUSED;
      text = text.isEmpty() ? e.getCause().toString() : text;
    }
    return new Row(source, file, result, size, (System.nanoTime() - start) / 1e9, text);
  }

  /** Returns the place and the message of a refusal; empty for any other exception. */
  private static String reason(Path file, Throwable failure) {
    if (failure instanceof SceneFormatException refusal) {
      return refusal.problems().stream()
          .limit(1)
          .map(problem -> problem.path() + ": " + problem.message())
          .collect(joining());
    }
    boolean isRefusal = failure instanceof ImageFormatException && ModelSource.isSky(file);
    return isRefusal ? failure.getMessage() : "";
  }

  private static Content model(Path file) throws SceneFormatException, IOException {
    SceneFile scene = StagedModel.read(file, Stage.DEFAULT, new SceneParser()).scene();
    List<String> warnings =
        scene.warnings().stream().map(w -> w.path() + ": " + w.message()).toList();
    return new Content(scene.parsed().contents().triangles(), warnings);
  }

  private static Content sky(Path file) throws IOException {
    var image = LinearReader.read(file);
    return new Content((long) image.width() * image.height(), List.of());
  }
}
