package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.Release;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** The manual page of a command in roff, with the macros of man(7): what its help lists in full. */
final class ManPage {
  private final CommandSpec spec;
  private final UsageMessageSpec usage;
  private final StringBuilder page = new StringBuilder();

  private ManPage(CommandSpec spec) {
    this.spec = spec;
    usage = spec.usageMessage();
  }

  static String of(CommandSpec spec) {
    return new ManPage(spec).text();
  }

  private String text() {
    String name = spec.qualifiedName("-");
    String title = name.toUpperCase(Locale.ROOT);
    page.append(".TH \"").append(title).append("\" 1 \"\" \"Lumbre ").append(Release.number());
    page.append("\" \"Lumbre manual\"\n");
    section("NAME");
    String header = String.join(" ", usage.header()).replaceFirst("^Lumbre, an? ", "");
    line(escaped(name) + " \\- " + escaped(header.replaceFirst("\\.$", "")));
    section("SYNOPSIS");
    String synopsis = new Help(spec, Help.defaultColorScheme(Ansi.OFF)).synopsis(0).strip();
    String after = synopsis.replaceAll("\\s+", " ").substring(spec.qualifiedName().length());
    line("\\fB" + escaped(spec.qualifiedName()) + "\\fR" + escaped(after));
    section("DESCRIPTION");
    line(escaped(String.join(" ", usage.header())));
    if (usage.description().length > 0) {
      line(escaped(HelpLayout.plain(usage.description())));
    }
    parameters();
    commands();
    flags();
    codes();
    examples();
    return page.toString();
  }

  private void parameters() {
    List<PositionalParamSpec> shown =
        spec.positionalParameters().stream().filter(p -> !p.hidden()).toList();
    if (!shown.isEmpty()) {
      section("ARGUMENTS");
      for (PositionalParamSpec each : shown) {
        item("\\fI" + escaped(each.paramLabel()) + "\\fR", HelpLayout.plain(each.description()));
      }
    }
  }

  private void commands() {
    if (spec.parent() == null) {
      section("COMMANDS");
      spec.subcommands()
          .forEach(
              (name, command) -> {
                String header = String.join(" ", command.getCommandSpec().usageMessage().header());
                item("\\fBlumbre\\-" + escaped(name) + "\\fR(1)", header);
              });
    }
  }

  private void flags() {
    section("OPTIONS");
    HelpLayout.divided(spec)
        .forEach(
            (heading, flags) -> {
              if (!heading.isEmpty() && !flags.isEmpty()) {
                page.append(".SS \"").append(escaped(heading)).append("\"\n");
              }
              flags.forEach(this::flag);
            });
  }

  private void flag(OptionSpec flag) {
    StringBuilder names = new StringBuilder();
    for (String name : flag.names()) {
      names.append(names.length() == 0 ? "" : ", ").append("\\fB").append(escaped(name));
      names.append("\\fR");
    }
    if (flag.arity().max() > 0) {
      names.append(" \\fI").append(escaped(flag.paramLabel())).append("\\fR");
    }
    item(names.toString(), HelpLayout.plain(flag.description()));
  }

  private void codes() {
    section("EXIT STATUS");
    Map<String, String> codes =
        usage.exitCodeList().isEmpty()
            ? ExitCode.meanings(EnumSet.complementOf(EnumSet.of(ExitCode.SAVED)), "")
            : usage.exitCodeList();
    codes.forEach((code, meaning) -> item(escaped(code.strip()), meaning));
  }

  private void examples() {
    List<String> lines =
        List.of(usage.footer()).stream().filter(line -> line.startsWith("  ")).toList();
    if (!lines.isEmpty()) {
      section("EXAMPLES");
      page.append(".nf\n");
      lines.forEach(line -> line(escaped(HelpLayout.plain(new String[] {line}))));
      page.append(".fi\n");
    }
    if (spec.parent() != null) {
      section("SEE ALSO");
      line("\\fBlumbre\\fR(1)");
    }
  }

  private void section(String name) {
    page.append(".SH ").append(name).append("\n");
  }

  /** Appends a paragraph with a tag; the text is not yet escaped, the tag is. */
  private void item(String tag, String text) {
    page.append(".TP\n");
    line(tag);
    line(escaped(text));
  }

  /** Appends a line of text that roff takes for no request. */
  private void line(String escaped) {
    boolean isRequest = escaped.startsWith(".") || escaped.startsWith("'");
    page.append(isRequest ? "\\&" : "").append(escaped).append("\n");
  }

  /** Returns a text with the characters that roff treats otherwise. */
  private static String escaped(String text) {
    return text.replace("\\", "\\e")
        .replace("-", "\\-")
        .replace("'", "\\(aq")
        .replace("`", "\\(ga");
  }
}
