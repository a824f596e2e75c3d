package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.option.FlagConverters.Shell;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code lumbre completion}: prints a shell completion script. */
@Command(
    name = "completion",
    header = "Print a completion script for a shell.",
    footer = {
      "",
      "Examples:",
      "  source <(lumbre completion)",
      "  lumbre completion --shell fish | source",
      "  lumbre completion --shell powershell | Out-String | Invoke-Expression"
    })
@Exits({ExitCode.OK, ExitCode.OUTPUT})
final class CompletionCommand extends Subcommand {
  @Option(
      names = "--shell",
      paramLabel = "bash|zsh|fish|powershell",
      defaultValue = "bash",
      description = "The shell that reads the script: bash, zsh, fish or powershell (bash).")
  private Shell shell;

  @Override
  ExitCode run() {
    List<Completion> commands = Completion.of(spec.root());
    String script =
        switch (shell) {
          case BASH, ZSH -> BashCompletion.of(commands);
          case FISH -> FishCompletion.of(commands);
          case POWERSHELL -> PowerShellCompletion.of(commands);
        };
    spec.commandLine().getOut().print(script);
    spec.commandLine().getOut().flush();
    return ExitCode.OK;
  }
}
