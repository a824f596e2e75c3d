package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.ProgressBar;
import io.github.lumbre.cli.output.ProgressDisplay;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.render.Bucket;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/**
 * Passes on what a render has done to a display, and to the render whether the program is to end or
 * a time has passed.
 */
public final class RenderMonitor implements LabHost.Display {
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
        hasDisplay ? ProgressBar.onStandardError() : ProgressDisplay.NONE,
        Deadline.NEVER,
        new Messages(new PrintWriter(System.err, true)));
  }

  /**
   * @param display shows the progress; closed by this monitor
   * @param deadline after which the render is to stop
   * @param messages where to say that a render has stalled
   */
  public RenderMonitor(
      Interruption interruption, ProgressDisplay display, Deadline deadline, Messages messages) {
    this.messages = messages;
    this.interruption = interruption;
    this.display = new AtomicReference<>(display);
    this.deadline = deadline;
  }

  /**
   * Reads a scene, and ends that when the program is to end or the time has passed.
   *
   * @throws TaskException also if that happened
   */
  public <T> T reading(Path scene, Interruption.Reading<T> action)
      throws TaskException, SceneFormatException {
    display.get().reading(String.valueOf(scene.getFileName()));
    return interruption.reading(deadline, action);
  }

  /**
   * Computes something that the result may lack.
   *
   * @return empty if the program is to end, or the time has passed, before that is done
   */
  <T> Optional<T> unlessStopped(Interruption.Waiting<T> action) {
    return interruption.unlessStopped(deadline, action);
  }

  /** Shows what else ends the render. */
  void limited(RunBudget budget) {
    display
        .get()
        .limited(() -> earlier(deadline.secondsLeft(), budget.secondsLeft()), budget.targetError());
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

  /** The running render will take about so many more samples. */
  void expected(long furtherSamples) {
    display.get().expected(furtherSamples);
  }

  @Override
  public void advanced(long samples) {
    display.get().advanced(samples);
  }

  /** The picture's error, relative to the picture, can be estimated now, which takes a moment. */
  void estimable(Supplier<OptionalDouble> relativeError) {
    display.get().estimable(relativeError);
  }

  @Override
  public void stalled(Bucket bucket, double seconds) {
    messages.line(
        String.format(
            Locale.ROOT,
            "warning: no sample of the bucket at %d,%d of %dx%d pixels has ended for %.0f s",
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

  /** Tells whether the time for the render has passed. */
  boolean isOutOfTime() {
    return deadline.hasPassed();
  }

  @Override
  public void close() {
    display.getAndSet(ProgressDisplay.NONE).close();
  }
}
