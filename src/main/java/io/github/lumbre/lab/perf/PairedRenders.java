package io.github.lumbre.lab.perf;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.MemoryCheck;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.metrics.PictureNoise;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Renders scenes alternately in one process with the baseline and with a plan's settings, so that
 * other load on the machine affects both equally. Each pair of renders has its own seed.
 *
 * <p>The ratios are medians; their intervals hold for every distribution. Each error comes from two
 * renders, so there are half as many error ratios.
 */
public final class PairedRenders {
  /** The smallest number of pairs for which error ratios have an interval. */
  public static final int FEWEST_PAIRS = 12;

  private final PerfPlan plan;
  private final LabHost host;

  /** One of the two compared settings, with its renders in order. */
  private static final class Way {
    private final Scene scene;
    private final RenderSettings settings;
    private final List<TimedRender> renders = new ArrayList<>();

    private Way(Scene scene, RenderSettings settings) {
      this.scene = scene;
      this.settings = settings;
    }

    /** Renders once and records the result. Returns false if stopped. */
    private boolean render(int number, int threads, LabHost host) throws InterruptedException {
      RenderSettings own =
          settings.toBuilder().threads(threads).seed(settings.seed() + number).build();
      TimedRender render;
      try (LabHost.Display display = host.display()) {
        render = TimedRender.of(scene, own, display);
      }
      renders.add(render);
      return render.result().complete();
    }

    private List<Image> pictures() {
      return renders.stream().map(render -> render.result().image()).toList();
    }
  }

  public PairedRenders(PerfPlan plan, LabHost host) {
    this.plan = plan;
    this.host = host;
  }

  /** Returns the lines above the rows, in Markdown. */
  public List<String> head() {
    return List.of(
        "Ratios to the baseline, medians of "
            + plan.repeat()
            + " alternating pairs with 95 % intervals; gain: 1 / (time × squared error). "
            + plan.sentences(),
        "",
        "| scene | size | samples | CPU time | memory allocated | squared error | gain | picture |",
        "|---|---|--:|---|---|---|---|---|");
  }

  /** Returns a scene's row; empty if stopped. */
  public Optional<String> row(Path scene)
      throws SceneFormatException, TaskException, InterruptedException {
    SceneParser parser = new SceneParser().overriding(plan.plain()::over);
    SceneFile file = host.read(scene, parser);
    MemoryCheck.require(file.settings(), FilmLayers.NONE);
    Way plain = new Way(file.scene(), file.settings());
    RenderSettings settings =
        file.settings().toBuilder().adaptive(plan.adaptive()).split(plan.split()).build();
    Way changed = new Way(plan.over(file).scene(), settings);
    int threads = plan.threads().get(0);
    for (int pair = 0; pair < plan.repeat() + 1; pair++) {
      // The order ABBA cancels a drift.
      Way first = pair % 2 == 0 ? plain : changed;
      Way second = pair % 2 == 0 ? changed : plain;
      if (!first.render(pair, threads, host) || !second.render(pair, threads, host)) {
        return Optional.empty();
      }
      if (pair == 0) {
        // The first pair warms up the JVM and is not counted.
        plain.renders.clear();
        changed.renders.clear();
      }
    }
    return Optional.of(row(SceneFolder.name(scene), plain, changed));
  }

  private static String row(String name, Way plain, Way changed) {
    List<Double> times = new ArrayList<>();
    List<Double> memory = new ArrayList<>();
    boolean isSame = true;
    for (int i = 0; i < plain.renders.size(); i++) {
      TimedRender a = plain.renders.get(i);
      TimedRender b = changed.renders.get(i);
      times.add(b.cpuSeconds() / a.cpuSeconds());
      memory.add((double) b.allocatedBytes() / a.allocatedBytes());
      isSame &= RasterHash.of(a.result().image()).equals(RasterHash.of(b.result().image()));
    }
    String errors = "| 1 | " + text(times, -1);
    if (!isSame) {
      List<Double> errorRatios = errorRatios(plain, changed);
      List<Double> products = new ArrayList<>();
      for (int i = 0; i < errorRatios.size(); i++) {
        products.add(errorRatios.get(i) * Math.sqrt(times.get(2 * i) * times.get(2 * i + 1)));
      }
      errors = "| " + text(errorRatios, 1) + " | " + text(products, -1);
    }
    RenderSettings settings = plain.settings;
    return String.format(
        Locale.ROOT,
        "| %s | %dx%d | %d | %s | %s %s | %s |",
        name,
        settings.width(),
        settings.height(),
        settings.samples(),
        text(times, 1),
        text(memory, 1),
        errors,
        isSame ? "same" : "different");
  }

  private static List<Double> errorRatios(Way plain, Way changed) {
    int even = plain.renders.size() / 2 * 2;
    List<Double> a = PictureNoise.of(plain.pictures().subList(0, even)).relativeMses();
    List<Double> b = PictureNoise.of(changed.pictures().subList(0, even)).relativeMses();
    List<Double> ratios = new ArrayList<>();
    for (int i = 0; i < a.size(); i++) {
      ratios.add(b.get(i) / a.get(i));
    }
    return ratios;
  }

  /** Returns the median of values or their reciprocals: {@code 0.980 (0.970 to 1.010)}. */
  private static String text(List<Double> values, int power) {
    Interval interval = Interval.ofMedian(values.stream().map(v -> power < 0 ? 1 / v : v).toList());
    return String.format(
        Locale.ROOT, "%.3f (%.3f to %.3f)", interval.value(), interval.low(), interval.high());
  }
}
