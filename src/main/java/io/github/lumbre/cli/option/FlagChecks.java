package io.github.lumbre.cli.option;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Checks of a command line that is syntactically valid. */
public record FlagChecks(CommandSpec spec) {
  /**
   * Requires a condition.
   *
   * @throws ParameterException with the message if the condition does not hold
   */
  public void require(boolean condition, String message) {
    if (!condition) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }

  /**
   * Requires a flag's value to lie in a closed range.
   *
   * @throws ParameterException that names the flag if the value does not
   */
  public void requireIn(String flag, int low, int high, int found) {
    require(
        low <= found && found <= high,
        flag + ": expected " + low + " to " + high + ", found " + found);
  }
}
