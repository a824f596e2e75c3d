package io.github.lumbre.cli.view;

import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.scene.RenderSettings;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What ends the render of a view besides its number of samples. Each view of the camera starts
 * anew.
 *
 * @param targetError relative error at which to stop, above 0
 * @param confidence confidence of the error bound, in [0.5,1)
 * @param time rendering time, without pauses
 */
public record ViewLimits(OptionalDouble targetError, double confidence, Optional<Duration> time) {
  /** Samples alone end the render. */
  public static final ViewLimits NONE =
      new ViewLimits(OptionalDouble.empty(), Budget.CONFIDENCE, Optional.empty());

  Budget budget(RenderSettings settings) {
    return new Budget(settings.samples(), targetError, confidence);
  }

  /** Returns the seconds that are left of the rendering time; empty without a time limit. */
  OptionalDouble secondsLeft(double seconds) {
    return time.stream().mapToDouble(limit -> limit.toNanos() * 1e-9 - seconds).findAny();
  }
}
