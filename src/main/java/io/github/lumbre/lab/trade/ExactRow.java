package io.github.lumbre.lab.trade;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.Pairs;
import io.github.lumbre.lab.Trial;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The comparison of a setting that must not change the picture with another value of it.
 *
 * @param setting name of the setting and its two values
 * @param timeRatio ratio of wall-clock times, from alternating renders; empty if a render is too
 *     short
 * @param cpuRatio ratio of CPU times; empty if a render is too short
 * @param isSamePicture whether the pictures are bit-identical
 */
public record ExactRow(
    String setting,
    Optional<Interval> timeRatio,
    Optional<Interval> cpuRatio,
    boolean isSamePicture) {
  private static final int PAIRS = 5;

  /** In a shorter time, the CPU clock, the JIT compiler and other programs hide the ratio. */
  private static final double LEAST_SECONDS = .1;

  /**
   * Renders all pairs. The first compares a setting with itself and shows the effect of chance.
   *
   * @param setting setting of all renders
   * @param samples samples per pixel
   */
  static List<ExactRow> all(TradeSetting setting, int samples) throws InterruptedException {
    Scene scene = setting.scene().scene();
    RenderSettings base = setting.settings().toBuilder().threads(1).bucketSize(32).build();
    Pairs.Side usual = side(setting, scene, base, samples);
    int processors = Runtime.getRuntime().availableProcessors();
    List<ExactRow> rows = new ArrayList<>();
    rows.add(of("no change (control)", usual, usual));
    if (processors > 1) {
      RenderSettings many = base.toBuilder().threads(processors).build();
      rows.add(of("threads " + processors + " / 1", usual, side(setting, scene, many, samples)));
    }
    for (int bucket : new int[] {8, 128}) {
      RenderSettings other = base.toBuilder().bucketSize(bucket).build();
      rows.add(of("bucket " + bucket + " / 32", usual, side(setting, scene, other, samples)));
    }
    if (Kernel.vectorObstacle().isEmpty()) {
      rows.add(
          of(
              "kernel vector / scalar",
              side(setting, scene.searchedBy(Kernel.SCALAR), base, samples),
              side(setting, scene.searchedBy(Kernel.VECTOR), base, samples)));
    }
    return rows;
  }

  private static Pairs.Side side(
      TradeSetting setting, Scene scene, RenderSettings settings, int samples) {
    return pair -> {
      Trial trial = new Trial(setting.renderer(scene, settings), Progress.NONE);
      trial.to(samples);
      return trial.develop();
    };
  }

  private static ExactRow of(String name, Pairs.Side base, Pairs.Side other)
      throws InterruptedException {
    Pairs pairs = Pairs.of(0, PAIRS, base, other);
    return new ExactRow(
        name,
        ratio(pairs.others(Cost::seconds), pairs.bases(Cost::seconds)),
        ratio(pairs.others(Cost::cpuSeconds), pairs.bases(Cost::cpuSeconds)),
        pairs.isSamePicture());
  }

  /** Returns the ratio of times in seconds; empty if one of them is too short to be measured. */
  static Optional<Interval> ratio(List<Double> over, List<Double> under) {
    return Stream.concat(over.stream(), under.stream()).allMatch(time -> time >= LEAST_SECONDS)
        ? Optional.of(Interval.ofRatios(over, under))
        : Optional.empty();
  }
}
