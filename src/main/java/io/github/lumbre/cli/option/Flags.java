package io.github.lumbre.cli.option;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Flags that several commands share, with access to the command that has them. */
@Command
abstract class Flags {
  @Spec(Spec.Target.MIXEE)
  CommandSpec spec;

  /**
   * Requires a condition.
   *
   * @throws ParameterException with the message if the condition does not hold
   */
  final void require(boolean condition, String message) {
    checks().require(condition, message);
  }

  /** Returns whether a flag of the command is given. */
  final boolean isGiven(String flag) {
    return spec.commandLine().getParseResult().hasMatchedOption(flag);
  }

  /** Returns the checks of the command's flags. */
  final FlagChecks checks() {
    return new FlagChecks(spec);
  }
}
