package io.github.lumbre.lab.perf;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.TextFile;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The times of a measurement, read from a file that {@link PerfTables} wrote.
 *
 * @param caption version, processor and JVM of the measurement
 * @param series one series for each scene and number of threads
 */
public record PerfTimes(String caption, List<Series> series) {
  public PerfTimes {
    series = List.copyOf(series);
  }

  /** The timed work; times of different work cannot be compared. */
  record Work(String scene, String size, String mode, int samples, int threads) {
    String text() {
      return String.format(
          Locale.ROOT, "%s, %s, %s, %d samples, %d threads", scene, size, mode, samples, threads);
    }
  }

  /**
   * The repetitions of one piece of work.
   *
   * @param seconds wall-clock times, each > 0
   * @param cpuSeconds CPU times of the process, each ≥ 0
   */
  record Series(
      Work work,
      String sceneHash,
      String imageHash,
      List<Double> seconds,
      List<Double> cpuSeconds) {}

  /** Returns the last series of a piece of work. */
  Optional<Series> series(Work work) {
    return series.stream().filter(s -> s.work.equals(work)).reduce((earlier, later) -> later);
  }

  /**
   * Reads a file.
   *
   * @throws TaskException with the exit code of an invalid command line, if the file cannot be read
   *     or is not a measurement
   */
  public static PerfTimes load(Path file) throws TaskException {
    String text = String.join("\n", TextFile.lines(file));
    try {
      return of(object(JsonParser.parseString(text), "a measurement"));
    } catch (JsonParseException | IllegalArgumentException e) {
      throw new TaskException(
          Kind.USAGE, file + ": expected a JSON file from 'lumbre perf': " + e.getMessage(), e);
    }
  }

  private static PerfTimes of(JsonObject root) {
    String format = text(root, "format");
    if (!format.equals(PerfTables.FORMAT)) {
      throw new IllegalArgumentException(
          "format: expected " + PerfTables.FORMAT + ", found " + format);
    }
    JsonObject machine = object(root.get("machine"), "machine");
    String caption =
        text(root, "version") + ", " + text(machine, "cpu") + ", " + text(machine, "jvm");
    List<Series> series = new ArrayList<>();
    for (JsonElement result : array(root, "results")) {
      series.add(series(object(result, "results")));
    }
    return new PerfTimes(caption, series);
  }

  private static Series series(JsonObject result) {
    List<Double> seconds = new ArrayList<>();
    List<Double> cpuSeconds = new ArrayList<>();
    for (JsonElement element : array(result, "repetitions")) {
      JsonObject repetition = object(element, "repetitions");
      seconds.add(number(repetition, "seconds", Double.MIN_VALUE));
      cpuSeconds.add(number(repetition, "cpu_seconds", 0));
    }
    Work work =
        new Work(
            text(result, "scene"),
            text(result, "size"),
            text(result, "mode"),
            (int) number(result, "samples", 1),
            (int) number(result, "threads", 1));
    return new Series(
        work, text(result, "scene_sha256"), text(result, "image_sha256"), seconds, cpuSeconds);
  }

  private static JsonObject object(JsonElement element, String name) {
    require(element != null && element.isJsonObject(), name, "an object");
    return element.getAsJsonObject();
  }

  private static Iterable<JsonElement> array(JsonObject parent, String name) {
    require(parent.has(name) && parent.get(name).isJsonArray(), name, "an array");
    return parent.getAsJsonArray(name);
  }

  private static String text(JsonObject parent, String name) {
    boolean isText = parent.get(name) instanceof JsonPrimitive value && value.isString();
    require(isText, name, "a string");
    return parent.get(name).getAsString();
  }

  private static double number(JsonObject parent, String name, double low) {
    boolean isNumber = parent.get(name) instanceof JsonPrimitive value && value.isNumber();
    double number = isNumber ? parent.get(name).getAsDouble() : Double.NaN;
    require(low <= number && number <= Double.MAX_VALUE, name, "a number of at least " + low);
    return number;
  }

  private static void require(boolean condition, String name, String expected) {
    if (!condition) {
      throw new IllegalArgumentException(name + ": expected " + expected);
    }
  }
}
