package io.github.lumbre.cli;

import java.util.ArrayList;
import java.util.List;

/** Collects a benchmark's results, and prints each in a table as soon as it is known. Mutable. */
final class BenchmarkReport {
  private final BenchmarkMarkdown table;
  private final Messages out;
  private final List<BenchmarkResult> results = new ArrayList<>();

  BenchmarkReport(BenchmarkMarkdown table, Messages out) {
    this.table = table;
    this.out = out;
  }

  /** Prints what comes before all results. */
  void begin() {
    table.head().forEach(out::line);
  }

  /** Takes and prints a result. */
  void add(BenchmarkResult result) {
    out.line(table.row(result));
    results.add(result);
  }

  /** Prints what comes after all results. */
  void end() {
    table.foot(results).forEach(out::line);
  }

  /** Returns the results so far. */
  List<BenchmarkResult> results() {
    return List.copyOf(results);
  }
}
