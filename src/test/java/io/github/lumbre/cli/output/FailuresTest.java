package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.Lumbre;
import io.github.lumbre.render.RenderException;
import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** Tests the messages and exit codes of program errors and exhausted memory. */
class FailuresTest {
  private final StringWriter err = new StringWriter();
  private final CommandLine command =
      new CommandLine(new Lumbre()).setErr(new PrintWriter(err, true));

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void faultsOfTheProgramAreToldAndEndItWithTheirOwnCode(boolean debug) {
    IllegalStateException cause = new IllegalStateException("planted");
    RenderException fault = new RenderException("rendering failed: " + cause, cause);

    assertThat(Failures.report(fault, command, debug)).isEqualTo(ExitCode.INTERNAL);
    assertThat(err.toString()).contains("internal error: rendering failed", "planted");
    assertThat(err.toString().contains("\tat ")).isEqualTo(debug);
  }

  @Test
  void messagesOfSeveralLinesAreCutToTheFirst() {
    Exception fault = new IllegalStateException("planted\nThis was created at:\n\nA.java:1");

    assertThat(Failures.report(fault, command, false)).isEqualTo(ExitCode.INTERNAL);
    assertThat(err.toString())
        .isEqualTo(
            "lumbre: internal error: java.lang.IllegalStateException: planted"
                + " (--debug prints the stack trace)\n");
  }

  @Test
  void lackOfMemoryIsALimit() {
    RenderException fault = new RenderException("rendering failed", new OutOfMemoryError());

    assertThat(Failures.report(fault, command, false)).isEqualTo(ExitCode.LIMIT);
    assertThat(err.toString()).contains("out of memory");
  }
}
