package io.github.lumbre.lab.checks;

import io.github.lumbre.lab.Table;
import java.util.List;
import java.util.Locale;

/** Formats the results of all invariants as the page docs/stability.md. */
public final class StabilityPage {
  private static final String ABOVE =
"""
# Stable at the extremes

The renderer's invariants at extreme scales, distances, roughnesses and depths, with measured worst
cases. `./lumbre selftest` measures them on any machine, one line each, and exits with code 1 if one
does not hold. `./lumbre selftest --markdown` prints this page. The tests check the same invariants,
with the code of the package `io.github.lumbre.lab.checks`. Fixed random keys give the same test
cases on every machine.

The invariants hold while the largest coordinate is at most 1e9 times the smallest visible feature.
Absolute size does not matter. `lumbre audit` warns about scenes beyond this ratio.\
""";

  private static final Table<Invariant.Outcome> TABLE =
      Table.<Invariant.Outcome>empty()
          .text("invariant", outcome -> outcome.law().name())
          .text("measured quantity", outcome -> outcome.law().statement())
          .text("range", outcome -> outcome.law().range())
          .text("worst", outcome -> figure(outcome.worst()))
          .text("limit", outcome -> figure(outcome.law().limit()));

  private StabilityPage() {}

  /** Returns the lines above the rows. */
  public static List<String> head() {
    return TABLE.head(ABOVE.split("\n"));
  }

  /** Returns the table row of an invariant. */
  public static String line(Invariant.Outcome outcome) {
    return TABLE.line(outcome);
  }

  /** Returns a number with three significant digits; integers below 1e6 in full. */
  public static String figure(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e6
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.format(Locale.ROOT, "%.3g", value);
  }
}
