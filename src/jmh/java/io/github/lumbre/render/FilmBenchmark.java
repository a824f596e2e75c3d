package io.github.lumbre.render;

import io.github.lumbre.MicroBenchmark;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Setup;

/** Summing samples. */
public class FilmBenchmark extends MicroBenchmark {
  private static final int SIDE = 64;

  private final Film film = new Film(new Crop(0, 0, SIDE, SIDE), false, 0);
  private Rgb[] values;

  @Setup
  public void prepare() {
    SplittableRandom random = new SplittableRandom(6);
    values = new Rgb[COUNT];
    Arrays.setAll(
        values, i -> new Rgb(random.nextDouble(), random.nextDouble(), random.nextDouble()));
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public Film add() {
    for (int i = 0; i < COUNT; i++) {
      film.add(i % (SIDE * SIDE), values[i], true);
    }
    return film;
  }
}
