package io.github.lumbre.render;

import io.github.lumbre.MicroBenchmark;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.internal.Passes;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Setup;

/**
 * What telling the noise takes: adding a sample as renders do, 64 to a pixel in their passes, and
 * without keeping what the noise is told from.
 */
public class NoiseKeepingBenchmark extends MicroBenchmark {
  private static final int SIDE = 32;
  private static final int SAMPLES = 64;
  private static final int ALL = SIDE * SIDE * SAMPLES;

  private final Film empty = new Film(new Crop(0, 0, SIDE, SIDE), false, 0);
  private final Film film = new Film(new Crop(0, 0, SIDE, SIDE), false, 0);
  private Rgb[] values;

  @Setup
  public void prepare() {
    SplittableRandom random = new SplittableRandom(8);
    values = new Rgb[COUNT];
    Arrays.setAll(
        values, i -> new Rgb(random.nextDouble(), random.nextDouble(), random.nextDouble()));
  }

  @Benchmark
  @OperationsPerInvocation(ALL)
  public Film keeping() {
    film.set(empty);
    int next = 0;
    for (int from = 0; from < SAMPLES; from = Passes.next(from, SAMPLES)) {
      int added = Passes.next(from, SAMPLES) - from;
      for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
        for (int i = 0; i < added; i++) {
          film.add(pixel, values[next++ % COUNT], true);
        }
      }
    }
    return film;
  }

  @Benchmark
  @OperationsPerInvocation(ALL)
  public Film without() {
    film.set(empty);
    int next = 0;
    for (int from = 0; from < SAMPLES; from = Passes.next(from, SAMPLES)) {
      int added = Passes.next(from, SAMPLES) - from;
      for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
        for (int i = 0; i < added; i++) {
          film.addSilently(pixel, values[next++ % COUNT], true);
        }
      }
    }
    return film;
  }
}
