package io.github.lumbre.cli;

import com.google.gson.JsonObject;
import java.util.OptionalDouble;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Supplier;

/**
 * Progress for programs to read: a JSON object a line, at the beginning, every second and at the
 * end.
 */
final class JsonProgress implements ProgressDisplay {
  private static final long INTERVAL_MILLIS = 1000;

  private final LongAdder done = new LongAdder();
  private final long total;
  private final Messages out;
  private final long start = System.nanoTime();
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "lumbre-progress");
            thread.setDaemon(true);
            return thread;
          });
  private volatile OptionalDouble error = OptionalDouble.empty();

  JsonProgress(long totalSamples, Messages out) {
    total = totalSamples;
    this.out = out;
    clock.scheduleAtFixedRate(this::print, 0, INTERVAL_MILLIS, TimeUnit.MILLISECONDS);
  }

  @Override
  public void advanced(long samples) {
    done.add(samples);
  }

  @Override
  public void estimable(Supplier<OptionalDouble> relativeError) {
    error = relativeError.get();
  }

  /** Prints the last line; none follows. */
  @Override
  public void close() {
    clock.shutdownNow();
    try {
      clock.awaitTermination(INTERVAL_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    print();
  }

  private void print() {
    out.line(line(done.sum(), total, (System.nanoTime() - start) * 1e-9, error));
  }

  /**
   * Returns {@code {"done":250,"total":1000,"seconds":50.0,"rate":5.0,"seconds_left":150.0}}; time
   * left and {@code relative_error} only if they are known.
   */
  static String line(long done, long total, double seconds, OptionalDouble relativeError) {
    JsonObject line = new JsonObject();
    line.addProperty("done", done);
    line.addProperty("total", total);
    line.addProperty("seconds", seconds);
    double rate = seconds > 0 ? done / seconds : 0;
    line.addProperty("rate", rate);
    if (rate > 0) {
      line.addProperty("seconds_left", Math.max(0, total - done) / rate);
    }
    relativeError.stream()
        .filter(Double::isFinite)
        .forEach(known -> line.addProperty("relative_error", known));
    return line.toString();
  }
}
