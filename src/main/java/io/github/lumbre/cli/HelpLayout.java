package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.option.Headings;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help;
import picocli.CommandLine.IHelpSectionRenderer;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * The layout of help texts: commands under the headings of their sections, flags under those that
 * their mixins state as {@code optionListHeading}. The width is picocli's: the terminal's, or 80
 * columns without one.
 */
final class HelpLayout {
  /** The headings that come first; the empty one is that of flags without a heading. */
  private static final List<String> FIRST = List.of("", Headings.SCENE, Headings.MODEL);

  private HelpLayout() {}

  static void applyTo(CommandLine program) {
    program.setUsageHelpAutoWidth(true);
    Map<String, IHelpSectionRenderer> sections = program.getHelpSectionMap();
    sections.remove(UsageMessageSpec.SECTION_KEY_COMMAND_LIST_HEADING);
    sections.put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST, HelpLayout::commands);
    program.getSubcommands().values().forEach(HelpLayout::applyToCommand);
  }

  private static void applyToCommand(CommandLine command) {
    Map<String, IHelpSectionRenderer> sections = command.getHelpSectionMap();
    sections.remove(UsageMessageSpec.SECTION_KEY_OPTION_LIST_HEADING);
    sections.put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, HelpLayout::flags);
    CommandSpec spec = command.getCommandSpec();
    Exits exits = spec.userObject().getClass().getAnnotation(Exits.class);
    if (exits != null) {
      Set<ExitCode> codes = EnumSet.of(ExitCode.USAGE, ExitCode.INTERNAL);
      codes.addAll(List.of(exits.value()));
      spec.usageMessage().exitCodeList(ExitCode.meanings(codes, exits.different()));
    }
    command.getSubcommands().values().forEach(HelpLayout::applyToCommand);
  }

  private static String commands(Help help) {
    StringBuilder text = new StringBuilder();
    Lumbre.SECTIONS.forEach(
        (heading, commands) -> {
          text.append(String.format("%n%s:%n", heading));
          for (Class<?> command : commands) {
            String header = command.getAnnotation(Command.class).header()[0];
            text.append(String.format("  %-12s%s%n", Lumbre.nameOf(command), header));
          }
        });
    return text.toString();
  }

  private static String flags(Help help) {
    StringBuilder text = new StringBuilder();
    divided(help.commandSpec())
        .forEach(
            (heading, flags) -> {
              // One layout for all flags: each list is as wide as the others.
              Help.Layout layout =
                  help.createDefaultLayout(
                      help.commandSpec().options(), List.of(), help.colorScheme());
              layout.addOptions(flags, help.parameterLabelRenderer());
              text.append(heading.isEmpty() ? "" : String.format("%n%s:%n", heading));
              text.append(layout);
            });
    return text.toString();
  }

  /** Returns the flags of a command under their headings; the empty one comes first. */
  static Map<String, List<OptionSpec>> divided(CommandSpec command) {
    Map<OptionSpec, String> headings = new IdentityHashMap<>();
    addHeadings(command, headings);
    Map<String, List<OptionSpec>> divided = new LinkedHashMap<>();
    FIRST.forEach(heading -> divided.put(heading, new ArrayList<>()));
    for (OptionSpec flag : command.options()) {
      if (!flag.hidden()) {
        String heading = headings.getOrDefault(flag, "");
        divided.computeIfAbsent(heading, key -> new ArrayList<>()).add(flag);
      }
    }
    divided.entrySet().removeIf(e -> !e.getKey().isEmpty() && e.getValue().isEmpty());
    return divided;
  }

  private static void addHeadings(CommandSpec command, Map<OptionSpec, String> headings) {
    for (CommandSpec mixin : command.mixins().values()) {
      String heading = mixin.usageMessage().optionListHeading();
      mixin.options().forEach(flag -> headings.put(flag, heading));
      addHeadings(mixin, headings);
    }
  }
}
