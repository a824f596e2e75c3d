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
 * Loads scenes alternately in one process: without and with decoding of unused meshes and textures.
 * Time and memory are those of the loading thread. With several processors, other threads build the
 * BVHs and are not included.
 */
public final class PairedLoads {
  /** The smallest number of pairs for which medians have an interval. */
  public static final int FEWEST_PAIRS = 6;

  /** Untimed pairs that warm up the JVM. */
  private static final int WARM_PAIRS = 5;

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private final int repeat;
  private final Consumer<String> warnings;

  /**
   * @param repeat number of timed pairs, at least {@link #FEWEST_PAIRS}
   * @param warnings receives the scenes' warnings
   */
  public PairedLoads(int repeat, Consumer<String> warnings) {
    this.warnings = warnings;
    this.repeat = repeat;
  }

  /** The cost of loading a scene once. */
  private record Load(double cpuSeconds, double bytes, int unused) {}

  /** Returns the lines above the rows, in Markdown. */
  public List<String> head() {
    return List.of(
        "Loading scenes, and the additional cost of decoding unused meshes and textures: medians of"
            + " "
            + repeat
            + " alternating pairs with 95 % intervals.",
        "",
        "| scene | unused | CPU ms | MB allocated | additional CPU ms | additional MB |",
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
      // The order ABBA cancels a drift.
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
