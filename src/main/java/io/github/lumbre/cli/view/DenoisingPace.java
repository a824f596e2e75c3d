package io.github.lumbre.cli.view;

import java.util.function.DoubleSupplier;

/**
 * Decides when the next picture of a render is denoised: at most once a second, and so that
 * denoising takes at most 3 % of the time, apart from the last picture. Mutable, for one thread.
 */
final class DenoisingPace {
  private static final double SHARE = .03;
  private static final double LEAST_SECONDS = 1;

  private final DoubleSupplier rendered;
  private double due = LEAST_SECONDS;

  /**
   * @param rendered the seconds of rendering, without denoising and pauses
   */
  DenoisingPace(DoubleSupplier rendered) {
    this.rendered = rendered;
  }

  boolean isDue() {
    return rendered.getAsDouble() >= due;
  }

  /**
   * Sets when the next picture is due.
   *
   * @param seconds that it took to denoise this one
   */
  void spend(double seconds) {
    due = rendered.getAsDouble() + Math.max(LEAST_SECONDS, seconds * (1 - SHARE) / SHARE);
  }
}
