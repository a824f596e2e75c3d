package io.github.lumbre.cli;

import io.github.lumbre.cli.output.Messages;
import java.util.stream.Collectors;
import picocli.CommandLine.Model.CommandSpec;

/** The command line that repeats a run. */
final class CommandText {
  private CommandText() {}

  /** Returns the command line of a running command, quoted for a shell. */
  static String of(CommandSpec spec) {
    return spec.commandLine().getParseResult().originalArgs().stream()
        .map(CommandText::quoted)
        .collect(Collectors.joining(" ", "lumbre ", ""));
  }

  /** Returns an argument, in quotes if a shell requires them. */
  private static String quoted(String argument) {
    String printable = Messages.printable(argument);
    return printable.matches("[\\w%+,./:=@-]+") ? printable : "'" + printable + "'";
  }
}
