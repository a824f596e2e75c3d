package io.github.lumbre.lab.trade;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.stream.Stream;

/**
 * Compares settings that must not change the picture. It renders them in pairs and alternates the
 * order, which cancels a drift of the machine.
 */
final class ExactPairs {
  private static final int PAIRS = 5;

  /** In a shorter time, the CPU clock, the JIT compiler and other programs hide the ratio. */
  private static final double LEAST_SECONDS = .1;

  private final TradeSetting setting;
  private final int samples;
  private final DoubleSupplier cpuSeconds;

  /** One of the two compared settings. */
  private record Side(Scene scene, RenderSettings settings) {}

  private record Timed(double seconds, double cpu, Image picture) {}

  /**
   * @param setting setting of all renders
   * @param samples samples per pixel
   */
  ExactPairs(TradeSetting setting, int samples, DoubleSupplier cpuSeconds) {
    this.setting = setting;
    this.samples = samples;
    this.cpuSeconds = cpuSeconds;
  }

  /** Renders all pairs. The first compares a setting with itself and shows the effect of chance. */
  List<ExactRow> rows() throws InterruptedException {
    Scene scene = setting.scene().scene();
    RenderSettings base = setting.settings().toBuilder().threads(1).bucketSize(32).build();
    Side usual = new Side(scene, base);
    int processors = Runtime.getRuntime().availableProcessors();
    List<ExactRow> rows = new ArrayList<>();
    rows.add(pairs("no change (control)", usual, usual));
    if (processors > 1) {
      Side many = new Side(scene, base.toBuilder().threads(processors).build());
      rows.add(pairs("threads " + processors + " / 1", usual, many));
    }
    for (int bucket : new int[] {8, 128}) {
      Side other = new Side(scene, base.toBuilder().bucketSize(bucket).build());
      rows.add(pairs("bucket " + bucket + " / 32", usual, other));
    }
    if (Kernel.vectorObstacle().isEmpty()) {
      Side scalar = new Side(scene.searchedBy(Kernel.SCALAR), base);
      Side vector = new Side(scene.searchedBy(Kernel.VECTOR), base);
      rows.add(pairs("kernel vector / scalar", scalar, vector));
    }
    return rows;
  }

  private ExactRow pairs(String name, Side base, Side other) throws InterruptedException {
    List<Double> baseSeconds = new ArrayList<>();
    List<Double> otherSeconds = new ArrayList<>();
    List<Double> baseCpu = new ArrayList<>();
    List<Double> otherCpu = new ArrayList<>();
    boolean same = true;
    for (int pair = 0; pair < PAIRS; pair++) {
      boolean swap = pair % 2 == 1;
      Timed first = timed(swap ? other : base);
      Timed second = timed(swap ? base : other);
      Timed ofBase = swap ? second : first;
      Timed ofOther = swap ? first : second;
      baseSeconds.add(ofBase.seconds);
      otherSeconds.add(ofOther.seconds);
      baseCpu.add(ofBase.cpu);
      otherCpu.add(ofOther.cpu);
      same &= Arrays.equals(first.picture.rgb(), second.picture.rgb());
    }
    return new ExactRow(name, ratio(otherSeconds, baseSeconds), ratio(otherCpu, baseCpu), same);
  }

  /** Returns the ratio of times in seconds; empty if one of them is too short to be measured. */
  static Optional<Interval> ratio(List<Double> over, List<Double> under) {
    return Stream.concat(over.stream(), under.stream()).allMatch(time -> time >= LEAST_SECONDS)
        ? Optional.of(Interval.ofRatios(over, under))
        : Optional.empty();
  }

  private Timed timed(Side side) throws InterruptedException {
    FilmRenderer renderer = setting.renderer(side.scene, side.settings);
    Film film = renderer.newFilm();
    double cpu = cpuSeconds.getAsDouble();
    long start = System.nanoTime();
    TradeClimb.climb(renderer, film, samples);
    double seconds = (System.nanoTime() - start) * 1e-9;
    double used = cpuSeconds.getAsDouble() - cpu;
    return new Timed(seconds, used, film.develop());
  }
}
