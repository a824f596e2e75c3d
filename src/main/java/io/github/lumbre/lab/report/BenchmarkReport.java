package io.github.lumbre.lab.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Collects a benchmark's results, and prints each in a table as soon as it is known. Mutable. */
public final class BenchmarkReport {
  private final BenchmarkMarkdown table;
  private final Consumer<String> out;
  private final List<BenchmarkResult> results = new ArrayList<>();

  public BenchmarkReport(BenchmarkMarkdown table, Consumer<String> out) {
    this.table = table;
    this.out = out;
  }

  /** Prints what comes before all results. */
  public void begin() {
    table.head().forEach(out);
  }

  /** Takes and prints a result. */
  public void add(BenchmarkResult result) {
    out.accept(table.row(result));
    results.add(result);
  }

  /** Prints what comes after all results. */
  public void end() {
    table.foot(results).forEach(out);
  }

  /** Returns the results so far. */
  public List<BenchmarkResult> results() {
    return List.copyOf(results);
  }
}
