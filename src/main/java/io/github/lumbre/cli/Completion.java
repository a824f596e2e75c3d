package io.github.lumbre.cli;

import io.github.lumbre.cli.option.Choices;
import io.github.lumbre.cli.option.FlagConverters;
import io.github.lumbre.model.Models;
import io.github.lumbre.stage.Stage.View;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * What a shell may complete after a command.
 *
 * @param name the command; empty for the program itself
 * @param header what it does, in one line
 * @param flags those that help shows
 * @param words commands that may follow
 * @param endings the endings of the files that it reads, such as {@code .json}; none: any
 * @param takesFiles whether it reads files at all
 */
record Completion(
    String name,
    String header,
    List<Flag> flags,
    List<String> words,
    List<String> endings,
    boolean takesFiles) {
  /** Names that flags with other values accept too. */
  private static final Map<String, List<String>> NAMES =
      Map.of(
          "--sky", List.of("relief", "studio", "white", "sun"),
          "--view", List.copyOf(View.standard().keySet()),
          "--background", List.of("sky", "transparent", "white", "black"));

  private static final String MODELS = Models.NAMES.replace(",", "") + " .vrm";

  /** The endings of the files that parameters with these labels name. */
  private static final Map<String, String> ENDINGS =
      Map.of("SCENE", ".json " + MODELS, "MODEL", MODELS, "FILM", ".film");

  /** Labels that list all values, such as {@code y|z}. */
  private static final String LIST_OF_VALUES = "[a-z0-9]+(\\|[a-z0-9]+)+";

  /** The kinds of values of a flag. */
  enum Kind {
    /** None: the flag stands alone. */
    NONE,
    /** One of the words; without words, what no shell knows. */
    WORDS,
    /** Words with commas between them. */
    LIST,
    /** A file, or one of the words. */
    FILES
  }

  /**
   * A flag.
   *
   * @param names such as {@code -o} and {@code --output}
   * @param words named values
   * @param meaning the first clause of its text
   */
  record Flag(List<String> names, Kind kind, List<String> words, String meaning) {
    private static Flag of(OptionSpec option) {
      List<String> words = NAMES.getOrDefault(option.longestName(), List.of());
      Kind kind = option.arity().max() == 0 ? Kind.NONE : Kind.WORDS;
      Optional<Choices> named = choices(option);
      if (named.isPresent()) {
        kind = named.get().isList() ? Kind.LIST : kind;
        words = named.get().choices();
      } else if (option.paramLabel().matches(LIST_OF_VALUES)) {
        words = List.of(option.paramLabel().split("\\|"));
      } else if (kind != Kind.NONE && isFile(option)) {
        kind = Kind.FILES;
      }
      String meaning = HelpLayout.firstClause(HelpLayout.plain(option.description()));
      return new Flag(List.of(option.names()), kind, words, meaning);
    }
  }

  /** Returns the program and its commands, in their order. */
  static List<Completion> of(CommandSpec program) {
    List<Completion> all = new ArrayList<>();
    all.add(of("", program));
    program
        .subcommands()
        .forEach((name, command) -> all.add(of(name, command.getCommandSpec())));
    return all;
  }

  private static Completion of(String name, CommandSpec command) {
    return new Completion(
        name,
        String.join(" ", command.usageMessage().header()),
        command.options().stream().filter(option -> !option.hidden()).map(Flag::of).toList(),
        subcommands(command),
        endings(command),
        command.positionalParameters().stream().anyMatch(Completion::isFile));
  }

  private static List<String> subcommands(CommandSpec command) {
    boolean isHelp = command.userObject() instanceof HelpCommand;
    Map<String, CommandLine> named = (isHelp ? command.parent() : command).subcommands();
    return List.copyOf(named.keySet());
  }

  /** Returns the named values of a flag; empty if it takes others. */
  static Optional<Choices> choices(OptionSpec option) {
    return option.converters().length == 1 && option.converters()[0] instanceof Choices choices
        ? Optional.of(choices)
        : Stream.concat(Stream.of(option.type()), Stream.of(option.auxiliaryTypes()))
            .flatMap(type -> FlagConverters.choices(type).stream())
            .findFirst();
  }

  private static List<String> endings(CommandSpec command) {
    return command.positionalParameters().stream()
        .map(ArgSpec::paramLabel)
        .distinct()
        .flatMap(label -> Arrays.stream(ENDINGS.getOrDefault(label, "").split(" ")))
        .filter(ending -> !ending.isEmpty())
        .toList();
  }

  private static boolean isFile(ArgSpec arg) {
    return arg.type() == Path.class
        || List.of(arg.auxiliaryTypes()).contains(Path.class)
        || arg.paramLabel().contains("FILE");
  }
}
