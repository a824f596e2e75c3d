package io.github.lumbre.cli;

import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.ExitCodes;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code lumbre completion}: prints a shell completion script. */
@Command(
    name = "completion",
    header = "Print a completion script for bash and zsh.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    footer = {"", "Example:", "  source <(lumbre completion)"})
final class CompletionCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Override
  public Integer call() {
    spec.commandLine().getOut().print(CompletionScript.of(spec.root()));
    spec.commandLine().getOut().flush();
    return ExitCodes.OK;
  }
}
