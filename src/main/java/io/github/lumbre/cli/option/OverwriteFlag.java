package io.github.lumbre.cli.option;

import io.github.lumbre.cli.output.OutputGuard;
import picocli.CommandLine.Option;

/** The flag of all commands that write files. */
public final class OverwriteFlag {
  @Option(
      names = "--overwrite",
      description = "Replace an existing output file even if it is of a different kind.")
  private boolean overwrite;

  public boolean isGiven() {
    return overwrite;
  }

  /** Returns a guard without files. */
  public OutputGuard guard() {
    return new OutputGuard(overwrite);
  }
}
