package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.Table;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.perf.PerfTimes.Series;
import io.github.lumbre.scene.SettingType;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The comparison of two measurements.
 *
 * @param rows work that both measured
 */
public record PerfComparison(
    PerfTimes first, PerfTimes second, Clock clock, List<PerfComparison.Row> rows) {
  private static final Table<Row> TABLE =
      Table.<Row>empty()
          .text("scene", row -> row.first.work().scene())
          .text("size", row -> row.first.work().size())
          .number("samples", row -> row.first.work().samples())
          .number("threads", row -> row.first.work().threads())
          .number("time B/A", row -> ratio(row.time))
          .text("95 %", row -> range(row.time))
          .number("CPU time B/A", row -> row.cpuTime.map(PerfComparison::ratio).orElse("-"))
          .text("95 %", row -> row.cpuTime.map(PerfComparison::range).orElse("-"))
          .text("B is", row -> SettingType.nameOf(row.verdict()).replace('-', ' '))
          .text("pictures", Row::pictures);

  /** The time that decides which measurement is faster. */
  public enum Clock {
    /** The process's CPU time, summed over processors: other load hardly affects it. */
    CPU,

    /** Wall-clock time: the time that users wait, including the cost of idle threads. */
    WALL
  }

  /** The result of a comparison of times. */
  enum Verdict {
    FASTER,
    SLOWER,
    NO_DIFFERENCE;

    /** Returns the verdict that the interval of a ratio supports. */
    static Verdict of(Interval ratio) {
      if (ratio.high() < 1) {
        return FASTER;
      }
      return ratio.low() > 1 ? SLOWER : NO_DIFFERENCE;
    }
  }

  /**
   * Work that both measured.
   *
   * @param cpuTime ratio of CPU times; empty if a render was too short for the CPU clock
   */
  record Row(Series first, Series second, Interval time, Optional<Interval> cpuTime, Clock clock) {
    static Row of(Series a, Series b, Clock clock) {
      boolean isCounted =
          Stream.of(a, b).flatMap(s -> s.cpuSeconds().stream()).allMatch(seconds -> seconds > 0);
      Interval time = Interval.ofUnpairedRatio(a.seconds(), b.seconds());
      Interval cpu = isCounted ? Interval.ofUnpairedRatio(a.cpuSeconds(), b.cpuSeconds()) : time;
      return new Row(a, b, time, Optional.of(cpu).filter(ratio -> isCounted), clock);
    }

    Verdict verdict() {
      return Verdict.of(clock == Clock.CPU ? cpuTime.orElse(time) : time);
    }

    boolean isSamePicture() {
      return first.imageHash().equals(second.imageHash());
    }

    String pictures() {
      boolean sameScene = first.sceneHash().equals(second.sceneHash());
      return isSamePicture() ? "same" : sameScene ? "differ" : "differ, as do the scenes";
    }
  }

  /**
   * Compares two measurements.
   *
   * @throws TaskException with the exit code of an invalid command line, if the two have no work in
   *     common or too few repetitions of it
   */
  public static PerfComparison of(PerfTimes first, PerfTimes second, Clock clock)
      throws TaskException {
    List<Row> rows = new ArrayList<>();
    try {
      for (Series a : first.series()) {
        second.series(a.work()).ifPresent(b -> rows.add(Row.of(a, b, clock)));
      }
    } catch (IllegalArgumentException e) {
      throw new TaskException(Kind.USAGE, e.getMessage(), e);
    }
    if (rows.isEmpty()) {
      throw new TaskException(
          Kind.USAGE,
          "expected measurements of the same scenes, sizes, samples and threads, found none");
    }
    return new PerfComparison(first, second, clock, rows);
  }

  /** Returns whether any work is slower in the second measurement or any picture differs. */
  public boolean isWorse() {
    return rows.stream().anyMatch(row -> row.verdict() == Verdict.SLOWER || !row.isSamePicture());
  }

  /** Returns the comparison as Markdown. */
  public List<String> lines() {
    List<String> head =
        TABLE.head(
            "A: Lumbre " + first.caption() + ".",
            "B: Lumbre " + second.caption() + ".",
            "Ratios of geometric means with 95 % confidence intervals (Welch's t test of"
                + " logarithms). About 1 of 20 rows without a difference will seem to have one."
                + (clock == Clock.CPU
                    ? " Column \"B is\": by CPU time."
                    : " Column \"B is\": by wall-clock time."));
    return Stream.of(
            head.stream(),
            rows.stream().map(TABLE::line),
            unmatched("A", first, second),
            unmatched("B", second, first))
        .flatMap(Function.identity())
        .toList();
  }

  private static String ratio(Interval interval) {
    return String.format(Locale.ROOT, "%.3f", interval.value());
  }

  private static String range(Interval interval) {
    return String.format(Locale.ROOT, "%.3f to %.3f", interval.low(), interval.high());
  }

  private static Stream<String> unmatched(String name, PerfTimes times, PerfTimes others) {
    return times.series().stream()
        .map(Series::work)
        .filter(work -> others.series(work).isEmpty())
        .map(work -> "Only in " + name + ": " + work.text());
  }
}
