package io.github.lumbre.cli.output;

import io.github.lumbre.base.file.ProcessEnd;
import java.io.PrintStream;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;

/**
 * A progress bar on the last line of a terminal, drawn by a daemon thread four times a second.
 * Mutable and thread-safe.
 *
 * <p>The cursor rests in the first column. If the window becomes narrower and the terminal wraps
 * the line, everything after the cursor is erased before the next redraw. The bar starts no program
 * that changes terminal settings or signal handling.
 */
public final class ProgressBar implements ProgressDisplay {
  private static final long INTERVAL_MILLIS = 250;

  /** The time after which an activity is shown that is no render, or that follows a render. */
  private static final double PATIENCE_SECONDS = 0.75;

  /** A longer gap between redraws means that the program was suspended; it is not render time. */
  private static final double SUSPENDED_SECONDS = 3;

  private static final long VANISH_MILLIS = 200;

  private final String title;
  private final PrintStream out;
  private final TerminalWidth width;
  private final boolean hasEscapes;
  private final DoubleSupplier clock;

  /** A striped counter, because worker threads report many times a second. */
  private final LongAdder done = new LongAdder();

  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "lumbre-bar");
            thread.setDaemon(true);
            return thread;
          });

  /** Guards the fields below and the terminal. */
  private final ReentrantLock lock = new ReentrantLock();

  private String activity = "";
  private long total;
  private BarStatus.Scale scale = BarStatus.Scale.UNKNOWN;
  private double start;

  /** The time at which the first of the activities since the last render began. */
  private double busySince;

  private double lastTick;
  private Supplier<OptionalDouble> secondsLeft = OptionalDouble::empty;
  private OptionalDouble targetError = OptionalDouble.empty();
  private OptionalDouble error = OptionalDouble.empty();
  private int drawn;
  private int drawnWidth;
  private boolean closed;

  private ProgressBar(
      String title,
      PrintStream out,
      TerminalWidth width,
      boolean hasEscapes,
      DoubleSupplier clock) {
    this.title = Messages.printable(title);
    this.out = out;
    this.width = width;
    this.hasEscapes = hasEscapes;
    this.clock = clock;
    start = clock.getAsDouble();
    lastTick = start;
  }

  /**
   * Returns a bar on standard error and starts to draw it.
   *
   * @param title start of its line, such as {@code 3/12 c.png}; may be empty
   */
  public static ProgressBar onStandardError(String title) {
    String terminal = System.getenv().getOrDefault("TERM", "dumb");
    ProgressBar bar =
        new ProgressBar(
            title,
            System.err,
            TerminalWidth.watching(),
            !terminal.equals("dumb"),
            () -> System.nanoTime() * 1e-9);
    shown().ifPresent(ProcessEnd::remove);
    ProcessEnd.add(bar);
    bar.timer.scheduleAtFixedRate(
        bar::tick, INTERVAL_MILLIS, INTERVAL_MILLIS, TimeUnit.MILLISECONDS);
    return bar;
  }

  /** Returns a bar that is drawn only by {@link #tick}. */
  static ProgressBar manual(
      String title,
      PrintStream out,
      TerminalWidth width,
      boolean hasEscapes,
      DoubleSupplier clock) {
    return new ProgressBar(title, out, width, hasEscapes, clock);
  }

  /** Returns the bar that is currently shown; it is erased before a line of text is printed. */
  private static Optional<ProgressBar> shown() {
    return ProcessEnd.open(ProgressBar.class).stream().findFirst();
  }

  /** Prints lines above the bar if one is shown: erases it first, and the next tick redraws it. */
  static void aside(Runnable print) {
    Optional<ProgressBar> shown = shown();
    if (shown.isEmpty()) {
      print.run();
      return;
    }
    ProgressBar bar = shown.get();
    bar.locked(
        () -> {
          bar.erase();
          print.run();
        });
  }

  /** Erases the bar permanently before the program exits, unless the terminal is blocked. */
  public static void vanish() {
    Optional<ProgressBar> shown = shown();
    try {
      if (shown.isPresent() && shown.get().lock.tryLock(VANISH_MILLIS, TimeUnit.MILLISECONDS)) {
        shown.get().erase();
        shown.get().closed = true;
        shown.get().lock.unlock();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void locked(Runnable action) {
    lock.lock();
    try {
      action.run();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void busy(String newActivity) {
    locked(
        () -> {
          start = clock.getAsDouble();
          if (activity.isEmpty()) {
            busySince = start;
          }
          activity = Messages.printable(newActivity);
        });
  }

  @Override
  public void started(long totalSamples) {
    locked(
        () -> {
          activity = "";
          done.reset();
          total = totalSamples;
          scale = BarStatus.Scale.UNKNOWN;
          start = clock.getAsDouble();
        });
  }

  @Override
  public void film(long pixels, long before, long firstPass) {
    locked(() -> scale = new BarStatus.Scale(pixels, before, firstPass, false, 0));
  }

  @Override
  public void expected(long furtherSamples) {
    locked(
        () -> {
          total = done.sum() + furtherSamples;
          scale = scale.forecast();
        });
  }

  @Override
  public void limited(Supplier<OptionalDouble> newSecondsLeft, OptionalDouble newTargetError) {
    locked(
        () -> {
          secondsLeft = newSecondsLeft;
          targetError = newTargetError;
        });
  }

  @Override
  public void advanced(long samples) {
    done.add(samples);
  }

  @Override
  public void estimable(Supplier<OptionalDouble> relativeError) {
    if (targetError.isPresent()) {
      OptionalDouble known = relativeError.get();
      locked(
          () -> {
            error = known;
            scale = scale.measuredAt(done.sum());
          });
    }
  }

  /** Erases the bar permanently. */
  @Override
  public void close() {
    timer.shutdownNow();
    locked(
        () -> {
          erase();
          closed = true;
        });
    width.close();
    ProcessEnd.remove(this);
  }

  /** Draws the current state of the bar. */
  void tick() {
    int columns = width.columns();
    locked(
        () -> {
          double now = clock.getAsDouble();
          if (now - lastTick > SUSPENDED_SECONDS) {
            start += now - lastTick;
          }
          lastTick = now;
          if (!closed) {
            draw(now - start, columns);
          }
        });
  }

  private void draw(double seconds, int columns) {
    if (!activity.isEmpty() && start + seconds - busySince < PATIENCE_SECONDS) {
      return;
    }
    if (drawn > 0 && columns != drawnWidth) {
      erase();
    }
    String head = title.isEmpty() ? "" : BarStatus.cut(title, columns / 3) + ": ";
    int room = columns - 1 - head.length();
    String text =
        head
            + (activity.isEmpty()
                ? status(seconds).line(room)
                : BarStatus.cut(activity + " ... " + clock(seconds), room));
    String rest = hasEscapes ? "\033[K" : " ".repeat(Math.max(0, drawn - text.length()));
    out.print("\r" + text + rest + "\r");
    out.flush();
    drawn = text.length();
    drawnWidth = columns;
  }

  private BarStatus status(double seconds) {
    return new BarStatus(done.sum(), total, seconds, secondsLeft.get(), error, targetError, scale);
  }

  private void erase() {
    if (drawn > 0) {
      out.print(hasEscapes ? "\r\033[J" : "\r" + " ".repeat(drawn) + "\r");
      out.flush();
      drawn = 0;
    }
  }

  /** Returns {@code 1:02:03}. */
  public static String clock(double seconds) {
    Duration time = Duration.ofSeconds(Math.round(seconds));
    return "%d:%02d:%02d".formatted(time.toHours(), time.toMinutesPart(), time.toSecondsPart());
  }
}
