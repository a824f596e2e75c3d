package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.lab.checks.Invariant;
import io.github.lumbre.lab.checks.Invariants;
import io.github.lumbre.lab.checks.StabilityPage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests {@code lumbre selftest} and its published table. */
class SelfTestCommandTest {
  private static final Invariant HOLDING =
      new Invariant("one", "share", "everywhere", 1e-3, tries -> 2e-4);
  private static final Invariant BROKEN = new Invariant("two", "leaks", "1 to 2", 0, tries -> 3);

  private static Outcome run(boolean markdown, Invariant... laws) throws InterruptedException {
    StringWriter out = new StringWriter();
    int code =
        SelfTestCommand.Checks.run(
                List.of(laws), markdown, new Messages(new PrintWriter(out, true)))
            .number();
    return new Outcome(code, out.toString(), "");
  }

  @Test
  void eachLawHasItsLine() throws InterruptedException {
    Outcome outcome = run(false, HOLDING, BROKEN);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.DIFFERENT);
    assertThat(outcome.out().lines())
        .containsExactly(
            "ok     one                    0.000200 (limit 0.00100): share; everywhere",
            "BROKEN two                    3 (limit 0): leaks; 1 to 2",
            "1 of 2 invariants hold");
    assertThat(run(false, HOLDING).exitCode()).isZero();
  }

  /** The published table lists exactly these checks, as written by the command. */
  @Test
  void publishedTableIsThatOfTheLaws() throws IOException, InterruptedException {
    List<String> page = Files.readAllLines(Path.of("docs", "stability.md"));
    List<String> head = StabilityPage.head();
    assertThat(page.subList(0, head.size())).isEqualTo(head);
    List<String> rows = page.subList(head.size(), page.size());
    assertThat(rows).hasSameSizeAs(Invariants.all());
    for (int i = 0; i < rows.size(); i++) {
      Invariant law = Invariants.all().get(i);
      assertThat(rows.get(i))
          .startsWith("| " + law.name() + " | " + law.statement() + " | ")
          .endsWith(" | " + StabilityPage.figure(law.limit()) + " |");
    }
    assertThat(run(true, HOLDING).out())
        .isEqualTo(
            String.join("\n", head) + "\n| one | share | everywhere | 0.000200 | 0.00100 |\n");
  }
}
