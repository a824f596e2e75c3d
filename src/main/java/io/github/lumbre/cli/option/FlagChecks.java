package io.github.lumbre.cli.option;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Complaints about a command line that could be read but makes no sense. */
public record FlagChecks(CommandSpec spec) {
  /**
   * Passes if a condition holds.
   *
   * @throws ParameterException with the message otherwise
   */
  public void require(boolean condition, String message) {
    if (!condition) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }

  /**
   * Passes if a flag's value lies between two others or is one of them.
   *
   * @throws ParameterException naming the flag otherwise
   */
  public void requireIn(String flag, int low, int high, int found) {
    require(
        low <= found && found <= high,
        flag + ": expected " + low + " to " + high + ", found " + found);
  }
}
