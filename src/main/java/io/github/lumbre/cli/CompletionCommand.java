package io.github.lumbre.cli;

import io.github.lumbre.cli.output.ExitCodes;
import picocli.CommandLine.Command;

/** {@code lumbre completion}: prints a shell completion script. */
@Command(
    name = "completion",
    header = "Print a completion script for bash and zsh.",
    footer = {"", "Example:", "  source <(lumbre completion)"},
    exitCodeList = {
      "0:Done",
      "2:The command line is invalid",
      "6:The script cannot be written",
      "7:Internal error"
    })
final class CompletionCommand extends Subcommand {
  @Override
  public Integer call() {
    spec.commandLine().getOut().print(CompletionScript.of(spec.root()));
    spec.commandLine().getOut().flush();
    return ExitCodes.OK;
  }
}
