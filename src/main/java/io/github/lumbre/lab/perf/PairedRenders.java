package io.github.lumbre.lab.perf;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.Pairs;
import io.github.lumbre.lab.Table;
import io.github.lumbre.lab.Trial;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.metrics.PictureNoise;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/**
 * Renders scenes alternately in one process with the baseline and with a plan's settings, so that
 * other load on the machine affects both equally. Each pair of renders has its own seed.
 *
 * <p>The ratios are medians; their intervals hold for every distribution. Each error comes from two
 * renders, so there are half as many error ratios.
 */
public record PairedRenders(PerfPlan plan, LabHost host) {
  /** The smallest number of pairs for which error ratios have an interval. */
  public static final int FEWEST_PAIRS = 12;

  private static final Table<Row> TABLE =
      Table.<Row>empty()
          .text("scene", row -> row.scene.name())
          .text("size", row -> row.scene.settings().width() + "x" + row.scene.settings().height())
          .number("samples", row -> row.scene.settings().samples())
          .text("CPU time", row -> median(row.times()))
          .text("memory allocated", row -> median(row.pairs.ratios(Cost::allocatedBytes)))
          .text("squared error", row -> row.isSame() ? "1" : median(row.errors()))
          .text("gain", row -> median(row.products().stream().map(v -> 1 / v).toList()))
          .text("picture", row -> row.isSame() ? "same" : "different");

  private record Row(MeasuredScene scene, Pairs pairs) {
    boolean isSame() {
      return pairs.isSamePicture();
    }

    List<Double> times() {
      return pairs.ratios(Cost::cpuSeconds);
    }

    /** Returns the ratio of squared errors of every two pairs. */
    List<Double> errors() {
      List<Double> base = errors(pairs.base());
      List<Double> other = errors(pairs.other());
      return IntStream.range(0, base.size()).mapToObj(i -> other.get(i) / base.get(i)).toList();
    }

    private static List<Double> errors(List<Trial.Outcome> renders) {
      int even = renders.size() / 2 * 2;
      return PictureNoise.of(renders.subList(0, even).stream().map(Trial.Outcome::picture).toList())
          .relativeMses();
    }

    /** Returns the ratios of time × squared error. */
    List<Double> products() {
      List<Double> times = times();
      if (isSame()) {
        return times;
      }
      List<Double> errors = errors();
      return IntStream.range(0, errors.size())
          .mapToObj(i -> errors.get(i) * Math.sqrt(times.get(2 * i) * times.get(2 * i + 1)))
          .toList();
    }
  }

  /** Returns the lines above the rows, in Markdown. */
  public List<String> head() {
    return TABLE.head(
        "Ratios to the baseline, medians of "
            + plan.repeat()
            + " alternating pairs with 95 % intervals; gain: 1 / (time × squared error). "
            + plan.sentences());
  }

  /**
   * Returns a scene's row.
   *
   * @throws InterruptedException if the host cancels a render
   */
  public String line(Path path)
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    SceneParser parser = new SceneParser().overriding(plan.plain()::over);
    MeasuredScene scene = MeasuredScene.read(path, parser, UnaryOperator.identity(), host);
    MeasuredScene changed = scene.with(plan.over(scene.file()));
    RenderSettings plain = scene.settings().toBuilder().threads(plan.threads().get(0)).build();
    RenderSettings other = plain.toBuilder().adaptive(plan.adaptive()).split(plan.split()).build();
    Pairs.Side first = pair -> scene.render(seeded(plain, pair));
    Pairs.Side second = pair -> changed.render(seeded(other, pair));
    // The first pair warms up the JVM and is not counted.
    Pairs.of(0, 1, first, second);
    return TABLE.line(new Row(scene, Pairs.of(1, plan.repeat() + 1, first, second)));
  }

  private static RenderSettings seeded(RenderSettings settings, int pair) {
    return settings.toBuilder().seed(settings.seed() + pair).build();
  }

  private static String median(List<Double> values) {
    return Interval.ofMedian(values).text(3);
  }
}
