package io.github.lumbre.cli;

import io.github.lumbre.cli.output.TerminalWidth;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.ColorScheme;
import picocli.CommandLine.IHelpFactory;
import picocli.CommandLine.IHelpSectionRenderer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * Fits help texts to the terminal, between 40 and 100 columns. Where two columns of text have no
 * room, the meaning of a flag stands below its name. The width is measured when help is printed,
 * since this takes a process. Mutable: measures once.
 */
final class HelpWidth implements IHelpFactory {
  private static final int LEAST = 40;
  private static final int MOST = 100;

  /** Narrower texts have one column. */
  private static final int FIRST_OF_TWO_COLUMNS = 72;

  /** A width in which picocli breaks no line of ours. */
  private static final int UNBROKEN = 2000;

  /** What continuations of a line are indented by: a list's first column, or spaces. */
  private static final Pattern INDENT = Pattern.compile(" {2}\\S+(, \\S+)* {2,}| *");

  private Optional<Integer> terminal;

  /**
   * Fits help texts to a width.
   *
   * @param terminal the width; empty to measure it
   */
  HelpWidth(Optional<Integer> terminal) {
    this.terminal = terminal;
  }

  @Override
  public Help create(CommandSpec command, ColorScheme colors) {
    // The help of the program includes those of all its commands.
    int columns = terminal.or(TerminalWidth::ofOutput).orElse(MOST);
    terminal = Optional.of(columns);
    int width = Math.max(LEAST, Math.min(MOST, columns));
    command.usageMessage().width(width < FIRST_OF_TWO_COLUMNS ? UNBROKEN : width);
    if (width < FIRST_OF_TWO_COLUMNS) {
      Map<String, IHelpSectionRenderer> sections = command.commandLine().getHelpSectionMap();
      sections.remove(UsageMessageSpec.SECTION_KEY_SYNOPSIS_HEADING);
      sections.put(UsageMessageSpec.SECTION_KEY_SYNOPSIS, HelpWidth::synopsis);
      sections.put(
          UsageMessageSpec.SECTION_KEY_PARAMETER_LIST,
          help -> list(help.commandSpec().positionalParameters(), help));
      sections.put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, HelpWidth::options);
      sections.replaceAll((key, section) -> help -> wrapped(section.render(help), width));
    }
    return new Help(command, colors);
  }

  private static String synopsis(Help help) {
    return help.synopsisHeading() + help.synopsis(help.synopsisHeadingLength());
  }

  private static String options(Help help) {
    if (!HelpLayout.isLong(help.commandSpec())) {
      return list(help.commandSpec().options(), help);
    }
    StringBuilder text = new StringBuilder();
    HelpLayout.divided(help.commandSpec())
        .forEach((heading, flags) -> text.append("\n" + heading + ":\n" + list(flags, help)));
    return text.toString();
  }

  /** Returns names with their meaning below. */
  private static String list(List<? extends ArgSpec> args, Help help) {
    StringBuilder text = new StringBuilder();
    for (ArgSpec arg : args) {
      if (!arg.hidden()) {
        text.append("  ").append(name(arg, help)).append("\n");
        for (String line : arg.description()) {
          String meaning = line.replace("%n", "\n").replace("%%", "%");
          meaning.lines().forEach(part -> text.append("      ").append(part).append("\n"));
        }
      }
    }
    return text.toString();
  }

  private static String name(ArgSpec arg, Help help) {
    String label =
        help.parameterLabelRenderer().renderParameterLabel(arg, help.ansi(), List.of()).toString();
    return arg instanceof OptionSpec option ? String.join(", ", option.names()) + label : label;
  }

  /** Breaks lines that are too long at spaces. */
  static String wrapped(String text, int width) {
    return text.lines().map(line -> broken(line, width) + "\n").collect(Collectors.joining());
  }

  private static String broken(String line, int width) {
    Matcher start = INDENT.matcher(line);
    int column = start.lookingAt() ? start.end() : 0;
    int indent = column == 2 ? 4 : column; // A continued command is indented once more.
    StringBuilder text = new StringBuilder();
    String rest = line;
    while (rest.length() > width) {
      int space = rest.lastIndexOf(' ', width);
      if (space <= indent) {
        space = rest.indexOf(' ', width);
      }
      if (space < 0) {
        break;
      }
      text.append(rest, 0, space).append("\n");
      rest = " ".repeat(indent) + rest.substring(space).strip();
    }
    return text.append(rest).toString();
  }
}
