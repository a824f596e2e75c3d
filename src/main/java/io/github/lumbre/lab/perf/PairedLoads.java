package io.github.lumbre.lab.perf;

import com.sun.management.ThreadMXBean;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * Reads scenes in two ways, in turn and in one process: plainly, and decoding what nothing uses,
 * too. Time and memory are those of the thread that reads, which is not the one that builds
 * hierarchies where there are several processors.
 */
public final class PairedLoads {
  /** So that medians have an interval. */
  public static final int FEWEST_PAIRS = 6;

  /** Pairs before those that count, in which the virtual machine warms up. */
  private static final int WARM_PAIRS = 5;

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private final int repeat;
  private final Consumer<String> warnings;

  /**
   * @param repeat how many pairs count, at least {@link #FEWEST_PAIRS}
   * @param warnings hears those of the scenes
   */
  public PairedLoads(int repeat, Consumer<String> warnings) {
    this.warnings = warnings;
    this.repeat = repeat;
  }

  /** What reading took. */
  private record Load(double cpuSeconds, double bytes, int unused) {}

  /** Returns the lines above the rows, in Markdown. */
  public List<String> head() {
    return List.of(
        "Reading scenes plainly, and what decoding unused meshes and textures takes in addition:"
            + " medians of "
            + repeat
            + " pairs in turn with intervals of 95 %.",
        "",
        "| scene | unused | CPU ms | MB allocated | CPU ms more | MB allocated more |",
        "|---|--:|---|---|---|---|");
  }

  /** Returns a scene's row. */
  public String row(Path scene) throws SceneFormatException, TaskException {
    SceneParser parser = new SceneParser();
    SceneFolder.load(scene, parser)
        .warnings()
        .forEach(warning -> warnings.accept(warning.toString()));
    SceneParser everything = parser.decodingUnused();
    List<Load> plain = new ArrayList<>();
    List<Load> all = new ArrayList<>();
    for (int pair = 0; pair < WARM_PAIRS + repeat; pair++) {
      // In the order ABBA, lest a drift favours one of them.
      boolean swap = pair % 2 == 1;
      Load first = load(scene, swap ? everything : parser);
      Load second = load(scene, swap ? parser : everything);
      if (pair >= WARM_PAIRS) {
        plain.add(swap ? second : first);
        all.add(swap ? first : second);
      }
    }
    return String.format(
        Locale.ROOT,
        "| %s | %d | %s | %s | %s | %s |",
        SceneFolder.name(scene),
        plain.get(0).unused,
        text(plain.stream().map(load -> 1e3 * load.cpuSeconds).toList()),
        text(plain.stream().map(load -> 1e-6 * load.bytes).toList()),
        text(differences(plain, all, 1e3, 0)),
        text(differences(plain, all, 0, 1e-6)));
  }

  private Load load(Path scene, SceneParser parser) throws SceneFormatException, TaskException {
    long cpu = THREADS.getCurrentThreadCpuTime();
    long bytes = THREADS.getCurrentThreadAllocatedBytes();
    SceneFile file = SceneFolder.load(scene, parser);
    return new Load(
        (THREADS.getCurrentThreadCpuTime() - cpu) * 1e-9,
        THREADS.getCurrentThreadAllocatedBytes() - bytes,
        file.origins().unused().size());
  }

  private static List<Double> differences(
      List<Load> plain, List<Load> all, double ofTime, double ofBytes) {
    List<Double> differences = new ArrayList<>();
    for (int i = 0; i < plain.size(); i++) {
      differences.add(
          ofTime * (all.get(i).cpuSeconds - plain.get(i).cpuSeconds)
              + ofBytes * (all.get(i).bytes - plain.get(i).bytes));
    }
    return differences;
  }

  private static String text(List<Double> values) {
    Interval interval = Interval.ofMedian(values);
    return String.format(
        Locale.ROOT, "%.2f (%.2f to %.2f)", interval.value(), interval.low(), interval.high());
  }
}
