package io.github.lumbre.lab.perf;

import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.metrics.RatioInterval;
import io.github.lumbre.lab.metrics.RatioInterval.Verdict;
import io.github.lumbre.lab.perf.PerfTimes.Series;
import io.github.lumbre.lab.perf.PerfTimes.Work;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Compares two measurements of the same work. */
public final class PerfComparison {
  private final PerfTimes first;
  private final PerfTimes second;
  private final Clock clock;
  private final List<Row> rows;

  /** The time that decides which measurement is faster. */
  public enum Clock {
    /** The process's CPU time, summed over processors: other load hardly affects it. */
    CPU,

    /** Wall-clock time: the time that users wait, including the cost of idle threads. */
    WALL
  }

  /**
   * Work that both measured.
   *
   * @param cpuTime ratio of CPU times; empty if a render was too short for the CPU clock
   */
  private record Row(
      Series first, Series second, RatioInterval time, Optional<RatioInterval> cpuTime) {
    public static Row of(Series a, Series b) {
      boolean isCounted =
          Stream.of(a, b).flatMap(s -> s.cpuSeconds().stream()).allMatch(seconds -> seconds > 0);
      return new Row(
          a,
          b,
          RatioInterval.of(a.seconds(), b.seconds()),
          isCounted
              ? Optional.of(RatioInterval.of(a.cpuSeconds(), b.cpuSeconds()))
              : Optional.empty());
    }

    Verdict verdict(Clock clock) {
      return (clock == Clock.CPU ? cpuTime.orElse(time) : time).verdict();
    }

    boolean isSamePicture() {
      return first.imageHash().equals(second.imageHash());
    }

    public boolean isWorse(Clock clock) {
      return verdict(clock) == Verdict.SLOWER || !isSamePicture();
    }
  }

  private PerfComparison(PerfTimes first, PerfTimes second, Clock clock, List<Row> rows) {
    this.first = first;
    this.second = second;
    this.clock = clock;
    this.rows = List.copyOf(rows);
  }

  /**
   * Compares two measurements.
   *
   * @throws TaskException with the exit code of an invalid command line, if the two have no work in
   *     common or too few repetitions of it
   */
  public static PerfComparison of(PerfTimes first, PerfTimes second, Clock clock)
      throws TaskException {
    Map<Work, Series> others = byWork(second);
    List<Row> rows = new ArrayList<>();
    try {
      for (Series series : first.series()) {
        if (others.containsKey(series.work())) {
          rows.add(Row.of(series, others.get(series.work())));
        }
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

  private static Map<Work, Series> byWork(PerfTimes times) {
    Map<Work, Series> byWork = new LinkedHashMap<>();
    times.series().forEach(series -> byWork.put(series.work(), series));
    return byWork;
  }

  /** Returns whether any work is slower in the second measurement or any picture differs. */
  public boolean isWorse() {
    return rows.stream().anyMatch(row -> row.isWorse(clock));
  }

  /** Returns the comparison as Markdown. */
  public List<String> lines() {
    Stream<String> head =
        Stream.of(
            "A: Lumbre " + first.caption() + ".",
            "B: Lumbre " + second.caption() + ".",
            "Ratios of geometric means with 95 % confidence intervals (Welch's t test of"
                + " logarithms). About 1 of 20 rows without a difference will seem to have one."
                + (clock == Clock.CPU
                    ? " Column \"B is\": by CPU time."
                    : " Column \"B is\": by wall-clock time."),
            "",
            Markdown.row(
                List.of(
                    "scene",
                    "size",
                    "samples",
                    "threads",
                    "time B/A",
                    "95 %",
                    "CPU time B/A",
                    "95 %",
                    "B is",
                    "pictures")),
            "|---|---|--:|--:|--:|---|--:|---|---|---|");
    Stream<String> notes = Stream.concat(unmatched("A", first), unmatched("B", second));
    return Stream.of(head, rows.stream().map(this::line), notes)
        .flatMap(Function.identity())
        .toList();
  }

  private String line(Row row) {
    Work work = row.first.work();
    List<String> cells = new ArrayList<>();
    cells.addAll(List.of(work.scene(), work.size()));
    cells.addAll(List.of(String.valueOf(work.samples()), String.valueOf(work.threads())));
    cells.addAll(cells(row.time));
    cells.addAll(row.cpuTime.map(PerfComparison::cells).orElse(List.of("-", "-")));
    cells.add(row.verdict(clock).toString());
    cells.add(pictures(row));
    return Markdown.row(cells);
  }

  private static List<String> cells(RatioInterval interval) {
    return List.of(
        String.format(Locale.ROOT, "%.3f", interval.ratio()),
        String.format(Locale.ROOT, "%.3f to %.3f", interval.low(), interval.high()));
  }

  private static String pictures(Row row) {
    if (row.isSamePicture()) {
      return "same";
    }
    boolean sameScene = row.first.sceneHash().equals(row.second.sceneHash());
    return sameScene ? "differ" : "differ, as do the scenes";
  }

  private Stream<String> unmatched(String name, PerfTimes times) {
    Map<Work, Series> known =
        rows.stream().collect(Collectors.toMap(r -> r.first.work(), r -> r.first));
    return times.series().stream()
        .map(Series::work)
        .filter(work -> !known.containsKey(work))
        .map(
            work ->
                "Only in "
                    + name
                    + ": "
                    + String.join(
                        ", ",
                        work.scene(),
                        work.size(),
                        work.mode(),
                        work.samples() + " samples",
                        work.threads() + " threads"));
  }
}
