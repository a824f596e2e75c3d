package io.github.lumbre.lab.checks;

import java.util.Locale;

/** The table of what holds at the extremes, as the documentation publishes it. */
public final class StabilityPage {
  public static final String HEAD =
      """
# Stable at the extremes

What the renderer promises where scenes are very large, very small, very near, very far, very smooth or
very deep, and what was measured. `./lumbre selftest` measures the same on any machine, a line for each
law, and ends with 1 if one does not hold; `./lumbre selftest --markdown` writes this page. The laws stand
in the package `laws`, which the tests measure as well. All is random by fixed keys: the same is tried everywhere.

Correct means: while the largest coordinate in play is at most 1e9 times the smallest visible feature.
Absolute size does not matter. `lumbre audit` warns of scenes beyond that.

| law | what is measured | over which range | worst | limit |
|---|---|---|---|---|
""";

  private StabilityPage() {}

  /** Returns a law's row. */
  public static String row(Invariant.Outcome outcome) {
    Invariant law = outcome.law();
    return "| "
        + String.join(
            " | ",
            law.name(),
            law.statement(),
            law.range(),
            figure(outcome.worst()),
            figure(law.limit()))
        + " |";
  }

  /** Returns a number with the digits that matter. */
  public static String figure(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e6
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.format(Locale.ROOT, "%.3g", value);
  }
}
