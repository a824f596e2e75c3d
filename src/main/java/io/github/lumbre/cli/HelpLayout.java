package io.github.lumbre.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** The layout of help texts: commands grouped by purpose, flags of long lists by subject. */
final class HelpLayout {
  /** The commands under each heading. */
  static final Map<String, List<String>> COMMANDS = new LinkedHashMap<>();

  /** The flags under each heading, by their long names. */
  static final Map<String, List<String>> FLAGS = new LinkedHashMap<>();

  /** Lists with more flags than this are grouped. */
  private static final int LONG = 18;

  private static final String REST = "Other";

  /** The heading of flags that only one command has. */
  private static final String OWN = "This command";

  static {
    COMMANDS.put(
        "Make pictures",
        List.of("render", "view", "resume", "merge", "develop", "denoise", "views", "import"));
    COMMANDS.put("Understand a scene", List.of("check", "audit", "pixel", "layers"));
    COMMANDS.put("Measure", List.of("compare", "trade", "perf", "selftest"));
    COMMANDS.put("The 2016 report", List.of("benchmark"));
    COMMANDS.put(REST, List.of("completion", "help"));

    FLAGS.put("Scene", List.of("--scene", "--strict", "--lenient", "--max-pixels"));
    FLAGS.put(
        "Model",
        List.of(
            "--camera",
            "--view",
            "--fov",
            "--sky",
            "--sky-intensity",
            "--sky-rotation",
            "--ground",
            "--background",
            "--turntable",
            "--pose",
            "--variant",
            "--up",
            "--unit"));
    FLAGS.put("Frame", List.of("--size", "--crop", "--filter"));
    FLAGS.put(
        "Light transport", List.of("--mode", "--depth", "--split", "--guide", "--clamp", "--seed"));
    FLAGS.put(
        "When to stop",
        List.of(
            "--samples",
            "--quality",
            "--target-error",
            "--confidence",
            "--time",
            "--timeout",
            "--adaptive",
            "--samples-from",
            "--samples-to",
            "--share"));
    FLAGS.put(
        "Picture file",
        List.of(
            "--output",
            "--format",
            "--exposure",
            "--tonemap",
            "--bits",
            "--jpeg-quality",
            "--layers",
            "--denoise",
            "--denoiser",
            "--oidn",
            "--denoise-timeout",
            "--overwrite",
            "--fallback-dir"));
    FLAGS.put("Checkpoints", List.of("--checkpoint", "--checkpoint-interval"));
    FLAGS.put("Execution", List.of("--threads", "--bucket", "--kernel", "--dry-run"));
    FLAGS.put(
        "Reports",
        List.of(
            "--port",
            "--no-open",
            "--compare",
            "--progress",
            "--json",
            "--stats",
            "--quiet",
            "--debug"));
    FLAGS.put("Help", List.of("--help", "--version"));
  }

  private HelpLayout() {}

  /** Groups the flags in the help texts of a command and its subcommands. */
  static void apply(CommandLine command) {
    command.getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, HelpLayout::options);
    command.getSubcommands().values().forEach(HelpLayout::apply);
  }

  /** Groups the program's list of commands. */
  static void applyToProgram(CommandLine program) {
    apply(program);
    program.setHelpFactory(new HelpWidth(Optional.empty()));
    program.getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST_HEADING, help -> "");
    program
        .getHelpSectionMap()
        .put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST, HelpLayout::commands);
  }

  private static String commands(Help help) {
    StringBuilder text = new StringBuilder();
    COMMANDS.forEach(
        (heading, names) -> {
          text.append(String.format("%n%s:%n", heading));
          for (String name : names) {
            String line = Lumbre.COMMANDS.get(name).getAnnotation(Command.class).header()[0];
            text.append(String.format("  %-12s%s%n", name, line));
          }
        });
    return HelpWidth.wrapped(text.toString(), help.commandSpec().usageMessage().width());
  }

  /** Returns whether the flags of a command are grouped. */
  static boolean isLong(CommandSpec command) {
    return visible(command).size() > LONG;
  }

  private static String options(Help help) {
    List<OptionSpec> all = visible(help.commandSpec());
    if (!isLong(help.commandSpec())) {
      return help.optionList();
    }
    StringBuilder text = new StringBuilder();
    divided(help.commandSpec())
        .forEach(
            (heading, flags) -> {
              // All flags set the column width, so that it is the same in every group.
              Help.Layout layout = help.createDefaultLayout(all, List.of(), help.colorScheme());
              layout.addOptions(flags, help.parameterLabelRenderer());
              text.append(String.format("%n%s:%n%s", heading, layout));
            });
    return text.toString();
  }

  private static List<OptionSpec> visible(CommandSpec command) {
    return command.options().stream().filter(option -> !option.hidden()).toList();
  }

  /** Returns the flags of a command under their headings, in order, each flag once. */
  static Map<String, List<OptionSpec>> divided(CommandSpec command) {
    Set<OptionSpec> left = new LinkedHashSet<>(visible(command));
    Map<String, List<OptionSpec>> divided = new LinkedHashMap<>();
    divided.put(OWN, List.of());
    FLAGS.forEach(
        (heading, names) -> {
          List<OptionSpec> found = new ArrayList<>();
          for (String name : names) {
            OptionSpec option = command.findOption(name);
            if (option != null && left.remove(option)) {
              found.add(option);
            }
          }
          if (!found.isEmpty()) {
            divided.put(heading, found);
          }
        });
    if (left.isEmpty()) {
      divided.remove(OWN);
    } else {
      divided.put(OWN, List.copyOf(left));
    }
    return divided;
  }
}
