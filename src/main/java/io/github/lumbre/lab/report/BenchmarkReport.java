package io.github.lumbre.lab.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Collects the results of a benchmark and prints each one as a table row. Mutable. */
public final class BenchmarkReport {
  private final BenchmarkMarkdown table;
  private final Consumer<String> out;
  private final List<BenchmarkResult> results = new ArrayList<>();

  public BenchmarkReport(BenchmarkMarkdown table, Consumer<String> out) {
    this.table = table;
    this.out = out;
  }

  /** Prints the caption and the header. */
  public void begin() {
    table.head().forEach(out);
  }

  /** Adds and prints a result. */
  public void add(BenchmarkResult result) {
    out.accept(table.row(result));
    results.add(result);
  }

  /** Prints the notes below the table. */
  public void end() {
    table.foot(results).forEach(out);
  }

  /** Returns the results so far. */
  public List<BenchmarkResult> results() {
    return List.copyOf(results);
  }
}
