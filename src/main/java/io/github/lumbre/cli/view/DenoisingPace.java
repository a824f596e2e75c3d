package io.github.lumbre.cli.view;

/**
 * Decides when the picture of a render is denoised: at most once a second of rendering, and so that
 * denoising takes 3 % of the time: 97/3 of its time follow before the next picture, except after
 * the first. Mutable, for one thread.
 */
final class DenoisingPace {
  private static final double SHARE = .03;
  private static final double LEAST_SECONDS = 1;

  private double due = LEAST_SECONDS;
  private boolean isFirst = true;

  /** Begins with another render. */
  void restart() {
    due = LEAST_SECONDS;
  }

  /**
   * Returns whether to denoise now.
   *
   * @param rendered seconds of rendering, without denoising and pauses
   */
  boolean isDue(double rendered) {
    return rendered >= due;
  }

  /**
   * Sets when the next picture is due.
   *
   * @param rendered seconds of rendering, without denoising and pauses
   * @param cost seconds of denoising this picture
   */
  void spend(double rendered, double cost) {
    // The first one also waits for the JIT, which says nothing about the next ones.
    double wait = isFirst ? 0 : cost * (1 - SHARE) / SHARE;
    isFirst = false;
    due = rendered + Math.max(LEAST_SECONDS, wait);
  }
}
