package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.option.FlagChecks;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.Messages;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What the commands of the program share. They return one of the codes of {@link Exits}. */
@Command(
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    exitCodeListHeading = "%nExit codes:%n")
abstract class Subcommand implements Callable<Object> {
  @Spec CommandSpec spec;

  @Override
  public final Object call() throws Exception {
    return run().number();
  }

  /** Runs the command; {@link io.github.lumbre.cli.output.Failures} reports its exceptions. */
  abstract ExitCode run() throws Exception;

  /** Returns the standard output. */
  final Messages out() {
    return new Messages(spec.commandLine().getOut());
  }

  /** Returns the standard error output. */
  final Messages errors() {
    return new Messages(spec.commandLine().getErr());
  }

  /**
   * Requires a condition.
   *
   * @throws ParameterException with the message if the condition does not hold
   */
  final void require(boolean condition, String message) {
    checks().require(condition, message);
  }

  /**
   * Requires a flag's value to lie in a closed range.
   *
   * @throws ParameterException that names the flag if the value does not
   */
  final void requireIn(String flag, int low, int high, int found) {
    checks().requireIn(flag, low, high, found);
  }

  /** Returns the checks of this command's flags. */
  final FlagChecks checks() {
    return new FlagChecks(spec);
  }
}
