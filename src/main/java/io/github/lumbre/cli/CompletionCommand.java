package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import picocli.CommandLine.Command;

/** {@code lumbre completion}: prints a shell completion script. */
@Command(
    name = "completion",
    header = "Print a completion script for bash and zsh.",
    footer = {"", "Example:", "  source <(lumbre completion)"})
@Exits({ExitCode.OK, ExitCode.OUTPUT})
final class CompletionCommand extends Subcommand {
  @Override
  ExitCode run() {
    spec.commandLine().getOut().print(CompletionScript.of(spec.root()));
    spec.commandLine().getOut().flush();
    return ExitCode.OK;
  }
}
