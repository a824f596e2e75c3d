package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.StandardOutput;
import java.io.PrintWriter;

/**
 * The main class of the jar. It answers {@code --version}, which scripts ask for often, without the
 * classes of the commands, and leaves all else to {@link Lumbre}.
 */
public final class Main {
  private Main() {}

  /** Runs the program and exits. */
  public static void main(String[] args) {
    if (!Version.isAskedForBy(args)) {
      Lumbre.main(args);
      return;
    }
    StandardOutput results = StandardOutput.open();
    PrintWriter out = new PrintWriter(results);
    Version.print(out);
    out.flush();
    int exitCode = results.exitCode(ExitCode.OK.number(), new PrintWriter(System.err, true));
    if (exitCode != ExitCode.OK.number()) {
      System.exit(exitCode);
    }
  }
}
