package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The repeated renders of one scene with the same settings.
 *
 * @param scene file name of the scene, without its extension
 * @param sceneHash SHA-256 of the scene and of every file it refers to
 * @param loadSeconds loading time of the scene
 * @param repetitions costs of the renders, all of the same picture
 * @param statistics statistics of one render
 * @param imageHash see {@link RasterHash}
 */
public record Measurement(
    String scene,
    String sceneHash,
    RenderSettings settings,
    double loadSeconds,
    List<Cost> repetitions,
    RenderStatistics statistics,
    String imageHash) {
  public Measurement {
    repetitions = List.copyOf(repetitions);
  }

  /** Returns the median wall-clock time. */
  public double seconds() {
    return median(Cost::seconds);
  }

  /** Returns the median CPU time of the process, summed over processors. */
  double cpuSeconds() {
    return median(Cost::cpuSeconds);
  }

  /** Returns the median number of allocated bytes per ray. */
  double bytesPerRay() {
    return median(Cost::allocatedBytes) / Math.max(1, rays());
  }

  private double median(ToDoubleFunction<Cost> value) {
    return Interval.median(repetitions.stream().mapToDouble(value).toArray());
  }

  /** Returns the number of rays traced in one render, including shadow rays. */
  public long rays() {
    return statistics.rays() + statistics.shadowRays();
  }

  /** Returns the frame size, {@code 1280x720}. */
  public String size() {
    return settings.width() + "x" + settings.height();
  }

  /** Returns the first digits of the picture's hash as code in Markdown. */
  public String image() {
    return "`" + imageHash.substring(0, RasterHash.SHOWN_DIGITS) + "`";
  }
}
