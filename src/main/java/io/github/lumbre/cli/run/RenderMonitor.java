package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.ProgressBar;
import io.github.lumbre.cli.output.ProgressDisplay;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/** Connects a render to its progress display, its deadline and the handling of signals. */
public final class RenderMonitor implements Progress, AutoCloseable {
  private final Interruption interruption;
  private final Deadline deadline;
  private final Messages messages;
  private final AtomicReference<ProgressDisplay> display;

  /**
   * @param hasDisplay whether to show a progress bar on standard error
   */
  public RenderMonitor(Interruption interruption, boolean hasDisplay) {
    this(
        interruption,
        hasDisplay ? ProgressBar.onStandardError("") : ProgressDisplay.NONE,
        Deadline.NEVER,
        new Messages(new PrintWriter(System.err, true)));
  }

  /**
   * @param display progress display; closed by this monitor
   * @param deadline time at which the render stops
   * @param messages printer of warnings about a stalled render
   */
  public RenderMonitor(
      Interruption interruption, ProgressDisplay display, Deadline deadline, Messages messages) {
    this.messages = messages;
    this.interruption = interruption;
    this.display = new AtomicReference<>(display);
    this.deadline = deadline;
  }

  /**
   * Shows that a scene is read. Until the result is closed, a signal or the deadline interrupts
   * this thread.
   */
  public Interruption.Wait reading(Path scene) {
    busy("reading " + scene.getFileName());
    return interruption.waiting(deadline);
  }

  /** Runs an action that reads a scene as {@link #reading(Path)} does. */
  public <T> T reading(Path scene, Callable<T> action) throws Exception {
    Interruption.Wait wait = reading(scene);
    try (wait) {
      return action.call();
    }
  }

  /** Runs a computation and shows it; returns nothing if a signal or the deadline stops it. */
  <T> Optional<T> unlessStopped(String activity, Interruption.Waiting<T> action) {
    busy(activity);
    return interruption.unlessStopped(deadline, action);
  }

  /**
   * Runs a step of a picture that has all its samples, and shows it.
   *
   * @param activity such as {@code denoising}
   * @return the result; empty if the step is not done within {@link Interruption#GRACE} after a
   *     signal or the deadline
   */
  public <T> Optional<T> finishing(String activity, Interruption.Waiting<T> action) {
    busy(activity);
    return interruption.finishing(deadline, action);
  }

  /** Shows an activity that is no render. */
  void busy(String activity) {
    display.get().busy(activity);
  }

  /** Shows the limits of the render other than its samples. */
  void limited(RunBudget budget) {
    display
        .get()
        .limited(() -> earlier(deadline.secondsLeft(), budget.secondsLeft()), budget.targetError());
  }

  /** Shows the size of a film and its existing samples; to be called after {@link #started}. */
  void film(Film film) {
    long pixels = film.window().pixels();
    // --timeout ends the first pass, too, but --time does not.
    boolean isFirst = film.fewestSamples() == 0 && deadline.secondsLeft().isEmpty();
    long first = isFirst ? Math.max(0, pixels * film.poses() - film.totalSamples()) : 0;
    display.get().film(pixels, film.totalSamples(), first);
  }

  private static OptionalDouble earlier(OptionalDouble one, OptionalDouble other) {
    return one.isPresent() && (other.isEmpty() || one.getAsDouble() < other.getAsDouble())
        ? one
        : other;
  }

  @Override
  public void started(long totalSamples) {
    display.get().started(totalSamples);
  }

  /** Shows an estimate of the remaining samples. */
  void expected(long furtherSamples) {
    display.get().expected(furtherSamples);
  }

  @Override
  public void advanced(long samples) {
    display.get().advanced(samples);
  }

  /** Shows the picture's relative error; its estimate is costly. */
  void estimable(Supplier<OptionalDouble> relativeError) {
    display.get().estimable(relativeError);
  }

  @Override
  public void stalled(Crop bucket, double seconds) {
    messages.line(
        String.format(
            Locale.ROOT,
            "warning: the bucket at %d,%d of %dx%d pixels has finished no sample for %.0f s",
            bucket.x(),
            bucket.y(),
            bucket.width(),
            bucket.height(),
            seconds));
  }

  @Override
  public boolean isCancelled() {
    return interruption.isRequested() || deadline.hasPassed();
  }

  /** Returns whether the deadline has passed. */
  boolean isOutOfTime() {
    return deadline.hasPassed();
  }

  @Override
  public void close() {
    display.getAndSet(ProgressDisplay.NONE).close();
  }
}
