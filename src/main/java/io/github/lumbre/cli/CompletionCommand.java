package io.github.lumbre.cli;

import io.github.lumbre.cli.output.ExitCodes;
import picocli.CommandLine.Command;

/** {@code lumbre completion}: prints a shell completion script. */
@Command(
    name = "completion",
    header = "Print a completion script for bash and zsh.",
    footer = {"", "Example:", "  source <(lumbre completion)"})
final class CompletionCommand extends Subcommand {
  @Override
  public Integer call() {
    spec.commandLine().getOut().print(CompletionScript.of(spec.root()));
    spec.commandLine().getOut().flush();
    return ExitCodes.OK;
  }
}
