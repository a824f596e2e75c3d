package io.github.lumbre.cli;

import io.github.lumbre.cli.output.Messages;
import java.util.stream.Collectors;
import picocli.CommandLine.Model.CommandSpec;

/** The command line by which a run can be repeated. */
final class CommandText {
  private CommandText() {}

  /** Returns the arguments of a command that is being executed, as a shell takes them. */
  static String of(CommandSpec spec) {
    return spec.commandLine().getParseResult().originalArgs().stream()
        .map(CommandText::quoted)
        .collect(Collectors.joining(" ", "lumbre ", ""));
  }

  /** Returns an argument in quotes, if a shell would not take it as it is. */
  private static String quoted(String argument) {
    String printable = Messages.printable(argument);
    return printable.matches("[\\w%+,./:=@-]+") ? printable : "'" + printable + "'";
  }
}
