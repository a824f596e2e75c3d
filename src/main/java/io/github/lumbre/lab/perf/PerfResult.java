package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.metrics.PictureNoise;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The measurement of a scene with one number of threads.
 *
 * @param scene file name of the scene, without its extension
 * @param sceneHash SHA-256 of the scene and of every file it refers to
 * @param settings settings of the renders
 * @param loadSeconds loading time of the scene
 * @param warmUp times of the first renders
 * @param repetitions the timed renders, all of the same picture
 * @param statistics statistics of one render
 * @param imageHash see {@link RasterHash}
 * @param noise noise of the picture, the same for any number of threads
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

  /** Returns the median wall-clock time. */
  double seconds() {
    return median(Repetition::seconds);
  }

  /** Returns the median CPU time of the process, summed over processors. */
  double cpuSeconds() {
    return median(Repetition::cpuSeconds);
  }

  /** Returns the median number of allocated bytes per ray. */
  double bytesPerRay() {
    return median(Repetition::allocatedBytes) / Math.max(1, rays());
  }

  private double median(ToDoubleFunction<Repetition> value) {
    return Interval.median(repetitions.stream().mapToDouble(value).toArray());
  }

  /** Returns the number of rays traced in one render, including shadow rays. */
  long rays() {
    return statistics.rays() + statistics.shadowRays();
  }

  /** Returns relative mean squared error × seconds; lower is better. */
  double errorSeconds() {
    return noise.relativeMse() * seconds();
  }

  /** Returns the seconds to {@link #TARGET}, assuming an error proportional to 1/samples. */
  double secondsToTarget() {
    return errorSeconds() / TARGET;
  }
}
