package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.option.Headings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help;
import picocli.CommandLine.IHelpSectionRenderer;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine;

/**
 * The layout of help texts: commands under the headings of their sections, flags under those that
 * their mixins state as {@code optionListHeading}. The width is picocli's: the terminal's, or 80
 * columns without one.
 *
 * <p>{@code --help} of a command with many flags lists those that people use, each with the first
 * sentence of its text; {@code --help all} lists all.
 */
final class HelpLayout {
  /** The headings that come first; the empty one is that of flags without a heading. */
  private static final List<String> FIRST = List.of("", Headings.SCENE, Headings.MODEL);

  /** The flags that the help of a command with more than {@link #MANY} shows. */
  private static final Set<String> USED =
      Set.of(
          "--output", "--help", "--camera", "--view", "--sky", "--ground", "--background",
          "--look", "--labels", "--up", "--section", "--hide", "--no-denoise", "--exposure",
          "--samples", "--size", "--time", "--target-error", "--turntable", "--animation",
          "--continue", "--checkpoint", "--timeout", "--json", "--port");

  private static final int MANY = 30;

  /** The number of examples in the help of such a command. */
  private static final int EXAMPLES = 4;

  private HelpLayout() {}

  /** Returns whether arguments ask for the help on all flags. */
  static boolean isForAll(String[] args) {
    int last = args.length - 1;
    return last > 0 && args[last].equals("all") && args[last - 1].matches("-h|--help");
  }

  /**
   * Sets the layout of all commands.
   *
   * @param isFull whether the help lists all flags
   */
  static void applyTo(CommandLine program, boolean isFull) {
    program.setUsageHelpAutoWidth(true);
    Map<String, IHelpSectionRenderer> sections = program.getHelpSectionMap();
    sections.remove(UsageMessageSpec.SECTION_KEY_COMMAND_LIST_HEADING);
    sections.put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST, HelpLayout::commands);
    program.getSubcommands().values().forEach(command -> applyToCommand(command, isFull));
  }

  private static void applyToCommand(CommandLine command, boolean isFull) {
    Map<String, IHelpSectionRenderer> sections = command.getHelpSectionMap();
    sections.remove(UsageMessageSpec.SECTION_KEY_OPTION_LIST_HEADING);
    CommandSpec spec = command.getCommandSpec();
    boolean hasMany = spec.options().stream().filter(o -> !o.hidden()).count() > MANY;
    boolean isShort = hasMany && !isFull;
    spec.usageMessage().abbreviateSynopsis(hasMany || spec.usageMessage().abbreviateSynopsis());
    sections.put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, help -> flags(help, isShort));
    if (isShort) {
      sections.remove(UsageMessageSpec.SECTION_KEY_EXIT_CODE_LIST_HEADING);
      sections.remove(UsageMessageSpec.SECTION_KEY_EXIT_CODE_LIST);
      sections.put(UsageMessageSpec.SECTION_KEY_FOOTER, HelpLayout::examples);
    }
    Exits exits = spec.userObject().getClass().getAnnotation(Exits.class);
    if (exits != null) {
      Set<ExitCode> codes = EnumSet.of(ExitCode.USAGE, ExitCode.INTERNAL);
      codes.addAll(List.of(exits.value()));
      spec.usageMessage().exitCodeList(ExitCode.meanings(codes, exits.different()));
    }
    command.getSubcommands().values().forEach(nested -> applyToCommand(nested, isFull));
  }

  private static String examples(Help help) {
    String[] footer = help.commandSpec().usageMessage().footer();
    String all = help.commandSpec().qualifiedName() + " --help all";
    return Stream.concat(
            Arrays.stream(footer).limit(2 + EXAMPLES),
            Stream.of("", "All flags, and the exit codes: " + all))
        .map(line -> String.format(line + "%n"))
        .collect(Collectors.joining());
  }

  /** Returns a flag of the short help; empty if it is not there. */
  private static Optional<OptionSpec> shortened(OptionSpec flag) {
    if (flag.usageHelp()) {
      return Optional.of(flag);
    }
    String first = firstClause(flag.description()[0]) + ".";
    return Arrays.stream(flag.names()).noneMatch(USED::contains)
        ? Optional.empty()
        : Optional.of(
            OptionSpec.builder(flag).description(first.replace("%", "%%")).build());
  }

  /** Returns a text up to the end of its first sentence or clause, outside of parentheses. */
  static String firstClause(String text) {
    return text.replaceFirst("^((?:[^(.;]|\\([^)]*\\)|\\.(?! |$))*)[.;](?: .*)?$", "$1");
  }

  /** Returns the lines of a description as one line, as picocli prints them. */
  static String plain(String[] lines) {
    return String.join(" ", lines).replace("%n", " ").replace("%%", "%").strip();
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

  private static String flags(Help help, boolean isShort) {
    StringBuilder text = new StringBuilder();
    Map<String, List<OptionSpec>> divided = divided(help.commandSpec());
    if (isShort) {
      divided.replaceAll(
          (heading, flags) ->
              flags.stream().map(HelpLayout::shortened).flatMap(Optional::stream).toList());
      divided.values().removeIf(List::isEmpty);
    }
    divided
        .forEach(
            (heading, flags) -> {
              // One layout for all flags: each list is as wide as the others.
              Help.Layout layout =
                  help.createDefaultLayout(
                      help.commandSpec().options(), List.of(), help.colorScheme());
              layout.addOptions(flags, help.parameterLabelRenderer());
              if (!heading.isEmpty()) {
                text.append(String.format(isShort ? "%s:%n" : "%n%s:%n", heading));
              }
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
