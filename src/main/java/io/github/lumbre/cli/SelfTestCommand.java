package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.lab.checks.Invariant;
import io.github.lumbre.lab.checks.Invariants;
import io.github.lumbre.lab.checks.StabilityPage;
import io.github.lumbre.lab.checks.Tries;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code lumbre selftest}: checks the renderer's invariants at extreme values on this machine. */
@Command(
    name = "selftest",
    header = "Check the renderer's invariants at extreme values on this machine.",
    description =
        "Print a line for each invariant: whether it holds, the largest deviation found, its limit"
            + " and the tested range. This takes about 20 s of CPU time.",
    footer = {
      "",
      "Examples:",
      "  lumbre selftest",
      "  lumbre selftest --markdown > docs/stability.md"
    })
@Exits(
    value = {ExitCode.OK, ExitCode.DIFFERENT},
    different = "an invariant does not hold")
final class SelfTestCommand extends Subcommand {
  @Option(names = "--markdown", description = "Print the page docs/stability.md.")
  private boolean markdown;

  @Override
  ExitCode run() throws InterruptedException {
    return Checks.run(Invariants.all(), markdown, out());
  }

  /** What needs the classes of the lab. */
  static final class Checks {
    /** Four times the tries of the build's tests. */
    private static final Tries TRIES = new Tries(4, 0);

    /** Checks invariants and prints a line for each as soon as its result is known. */
    static ExitCode run(List<Invariant> laws, boolean markdown, Messages out)
        throws InterruptedException {
      List<Invariant.Outcome> outcomes = new ArrayList<>();
      if (markdown) {
        StabilityPage.head().forEach(out::line);
      }
      for (Invariant law : laws) {
        Invariant.Outcome outcome = law.measure(TRIES);
        outcomes.add(outcome);
        out.line(markdown ? StabilityPage.line(outcome) : line(outcome));
      }
      boolean allHold = outcomes.stream().allMatch(Invariant.Outcome::holds);
      if (!markdown) {
        long held = outcomes.stream().filter(Invariant.Outcome::holds).count();
        out.line(held + " of " + outcomes.size() + " invariants hold");
      }
      return allHold ? ExitCode.OK : ExitCode.DIFFERENT;
    }

    private static String line(Invariant.Outcome outcome) {
      Invariant law = outcome.law();
      return String.format(
          Locale.ROOT,
          "%-6s %-22s %s (limit %s): %s; %s",
          outcome.holds() ? "ok" : "BROKEN",
          law.name(),
          StabilityPage.figure(outcome.worst()),
          StabilityPage.figure(law.limit()),
          law.statement(),
          law.range());
    }
  }
}
