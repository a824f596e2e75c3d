package io.github.lumbre.cli.output;

import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Supplier;

/** Prints progress as one JSON object per line: at the start, every second and at the end. */
public final class JsonProgress implements ProgressDisplay {
  private static final long INTERVAL_MILLIS = 1000;

  private final LongAdder done = new LongAdder();
  private final Messages out;
  private final Map<String, ?> place;
  private final AtomicBoolean isStarted = new AtomicBoolean();
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "lumbre-progress");
            thread.setDaemon(true);
            return thread;
          });
  private volatile long total;
  private volatile long start;
  private volatile Supplier<OptionalDouble> secondsLeft = OptionalDouble::empty;
  private volatile OptionalDouble error = OptionalDouble.empty();

  /**
   * @param place values with which each line begins, such as the number of the frame or the
   *     scene
   */
  public JsonProgress(Messages out, Map<String, ?> place) {
    this.out = out;
    this.place = place;
  }

  @Override
  public void started(long totalSamples) {
    total = totalSamples;
    start = System.nanoTime();
    if (!isStarted.getAndSet(true)) {
      clock.scheduleAtFixedRate(this::print, 0, INTERVAL_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  @Override
  public void expected(long furtherSamples) {
    total = done.sum() + furtherSamples;
  }

  @Override
  public void limited(Supplier<OptionalDouble> newSecondsLeft, OptionalDouble targetError) {
    secondsLeft = newSecondsLeft;
  }

  @Override
  public void advanced(long samples) {
    done.add(samples);
  }

  @Override
  public void estimable(Supplier<OptionalDouble> relativeError) {
    error = relativeError.get();
  }

  /** Prints the last line and stops. */
  @Override
  public void close() {
    clock.shutdownNow();
    try {
      clock.awaitTermination(INTERVAL_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (isStarted.get()) {
      print();
    }
  }

  private void print() {
    double seconds = (System.nanoTime() - start) * 1e-9;
    out.line(line(place, done.sum(), total, seconds, secondsLeft.get(), error));
  }

  /**
   * Returns {@code {"done":250,"total":1000,"seconds":50.0,"rate":5.0,"seconds_left":150.0}};
   * total, time left and {@code relative_error} only if they are known.
   *
   * @param place values with which the line begins
   * @param total 0 if it is not known
   * @param limit remaining seconds of the time limit; empty if there is none
   */
  static String line(
      Map<String, ?> place,
      long done,
      long total,
      double seconds,
      OptionalDouble limit,
      OptionalDouble relativeError) {
    JsonObject line = new JsonObject();
    place.forEach(
        (key, value) ->
            line.add(
                key,
                value instanceof Number number
                    ? new JsonPrimitive(number)
                    : new JsonPrimitive(value.toString())));
    line.addProperty("done", done);
    if (total > 0) {
      line.addProperty("total", total);
    }
    line.addProperty("seconds", seconds);
    double rate = seconds > 0 ? done / seconds : 0;
    line.addProperty("rate", rate);
    boolean isBounded = rate > 0 && total > 0;
    double ofRate = isBounded ? Math.max(0, total - done) / rate : Double.POSITIVE_INFINITY;
    double left = Math.min(ofRate, Math.max(0, limit.orElse(Double.POSITIVE_INFINITY)));
    if (Double.isFinite(left)) {
      line.addProperty("seconds_left", left);
    }
    relativeError.stream()
        .filter(Double::isFinite)
        .forEach(known -> line.addProperty("relative_error", known));
    return line.toString();
  }
}
