package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code lumbre man}: prints manual pages. */
@Command(
    name = "man",
    header = "Print the manual page of the program or of a command, for man.",
    footer = {"", "Example:", "  lumbre man render | man -l -"})
@Exits({ExitCode.OK, ExitCode.OUTPUT})
final class ManCommand extends Subcommand {
  @Parameters(
      arity = "0..1",
      paramLabel = "COMMAND",
      description = "The command (the program with a list of its commands).")
  private Optional<String> command = Optional.empty();

  @Override
  ExitCode run() {
    CommandLine program = spec.root().commandLine();
    CommandLine shown = command.isEmpty() ? program : program.getSubcommands().get(command.get());
    require(
        shown != null,
        "COMMAND: expected one of %s, found '%s'"
            .formatted(String.join(", ", program.getSubcommands().keySet()), command.orElse("")));
    spec.commandLine().getOut().print(ManPage.of(shown.getCommandSpec()));
    spec.commandLine().getOut().flush();
    return ExitCode.OK;
  }
}
