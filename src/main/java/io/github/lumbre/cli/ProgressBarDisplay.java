package io.github.lumbre.cli;

import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.atomic.LongAdder;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressState;

/** A progress bar on standard error; the only class that knows the library which draws it. */
final class ProgressBarDisplay implements ProgressDisplay {
  private static final int UPDATE_MILLIS = 250;
  private static final int BAR_CELLS = 30;

  /** One for each thread in effect: workers report many times a second. */
  private final LongAdder done = new LongAdder();

  private final ProgressBar bar;

  ProgressBarDisplay(long totalSamples) {
    bar =
        new ProgressBarBuilder()
            .setInitialMax(totalSamples)
            .setUpdateIntervalMillis(UPDATE_MILLIS)
            .setConsumer(new ConsoleProgressBarConsumer(System.err))
            .setRenderer(this::draw)
            .clearDisplayOnFinish()
            .build();
  }

  @Override
  public void advanced(long samples) {
    done.add(samples);
  }

  @Override
  public void close() {
    bar.close();
  }

  private String draw(ProgressState state, int width) {
    String line = line(done.sum(), state.getMax(), state.getTotalElapsed());
    return line.substring(0, Math.min(line.length(), Math.max(width, 0)));
  }

  /** Returns {@code 42 % [=====> ] 1.5 M samples/s, 0:00:12 left}. */
  static String line(long done, long total, Duration elapsed) {
    double fraction = total == 0 ? 1 : Math.min(1, (double) done / total);
    double seconds = elapsed.toNanos() * 1e-9;
    int cells = (int) (fraction * BAR_CELLS);
    String cellsDone = "=".repeat(cells) + (cells < BAR_CELLS ? ">" : "");
    String left = fraction == 0 ? "" : ", " + clock(seconds / fraction * (1 - fraction)) + " left";
    return String.format(
        Locale.ROOT,
        "%3d %% [%-" + BAR_CELLS + "s] %s samples/s%s",
        (int) (100 * fraction),
        cellsDone,
        Summary.rate(done, seconds),
        left);
  }

  private static String clock(double seconds) {
    long s = Math.round(seconds);
    return String.format(Locale.ROOT, "%d:%02d:%02d", s / 3600, s / 60 % 60, s % 60);
  }
}
