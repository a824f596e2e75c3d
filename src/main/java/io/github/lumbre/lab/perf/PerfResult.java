package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.metrics.PictureNoise;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * What a scene took with one number of threads.
 *
 * @param scene its file's name, without the ending
 * @param sceneHash SHA-256 of the scene and of every file it refers to
 * @param settings that it was rendered by
 * @param loadSeconds that reading it took
 * @param warmUp how fast the first renders were
 * @param repetitions the timed renders, all of the same picture
 * @param statistics of one of them
 * @param imageHash see {@link RasterHash}
 * @param noise of the picture, the same for any number of threads
 */
public record PerfResult(
    String scene,
    String sceneHash,
    RenderSettings settings,
    double loadSeconds,
    WarmUp warmUp,
    List<Repetition> repetitions,
    RenderStatistics statistics,
    String imageHash,
    PictureNoise noise) {
  /** The relative mean squared error that times are extrapolated to. */
  static final double TARGET = .01;

  public PerfResult {
    repetitions = List.copyOf(repetitions);
  }

  /**
   * A timed render.
   *
   * @param seconds see {@link TimedRender}
   */
  record Repetition(double seconds, double cpuSeconds, long allocatedBytes) {}

  /** Returns the median time by the clock on the wall. */
  double seconds() {
    return median(Repetition::seconds);
  }

  /** Returns the median time of the process, summed over processors. */
  double cpuSeconds() {
    return median(Repetition::cpuSeconds);
  }

  /** Returns the median of the bytes allocated for each ray. */
  double bytesPerRay() {
    return median(Repetition::allocatedBytes) / Math.max(1, rays());
  }

  private double median(ToDoubleFunction<Repetition> value) {
    return Interval.median(repetitions.stream().mapToDouble(value).toArray());
  }

  /** Returns how many rays were followed in one render, shadow rays included. */
  long rays() {
    return statistics.rays() + statistics.shadowRays();
  }

  /** Returns relative mean squared error times seconds: what a faster or better renderer lowers. */
  double errorSeconds() {
    return noise.relativeMse() * seconds();
  }

  /** Returns the seconds to {@link #TARGET}, if the error goes down as 1/samples. */
  double secondsToTarget() {
    return errorSeconds() / TARGET;
  }
}
