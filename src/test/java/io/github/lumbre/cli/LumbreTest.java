package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Suggestions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Tests help, version, completion and errors of the command line. */
class LumbreTest {
  /** The command that picocli makes itself has no list of exit codes. */
  @Test
  void noHeadingOfAHelpTextIsEmpty() {
    for (String command : Lumbre.commandLine().getSubcommands().keySet()) {
      String text = Outcome.of("help", command).out();
      assertThat(text.strip()).as(command).doesNotContainPattern(":\\R\\s*\\R").doesNotEndWith(":");
    }
  }

  @Test
  void namesInOtherProgramsLeadToFlagsAndCommandsThatExist() {
    Map<String, CommandLine> commands = Lumbre.commandLine().getSubcommands();
    Set<String> flags = commands.get("render").getCommandSpec().optionsMap().keySet();
    Suggestions.knownFlags()
        .forEach(
            (other, here) -> {
              assertThat(flags).as(other).contains(here.split(" ")[0]);
              assertThat(flags).as("has its own meaning here").doesNotContain("--" + other);
            });
    Suggestions.knownCommands()
        .forEach(
            (other, here) ->
                assertThat(commands).containsKey(here.split(" ")[0]).doesNotContainKey(other));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "nonsense                       | lumbre: unknown command nonsense (see",
        "rendr s.json -s 4              | unknown command rendr; did you mean render? (see",
        "render -x.json                 | '-x.json'; a file of this name is written ./-x.json",
        "render s.json -a.json          | '-a.json'; a file of this name is written ./-a.json",
        "render s.json --sampels 4      | unknown option '--sampels'; did you mean --samples?",
        "render -würfel.obj             | a file of this name is written ./-würfel.obj",
        "render --sise=3x4              | unknown option '--sise=3x4'; did you mean --size?",
        "render                         | SCENE",
        "render s.json --nonsense       | --nonsense",
        "render s.json two.json         | two.json",
        "render s.json -s 0             | --samples: expected 1 to 1073741824, found 0",
        "render s.json -s -1            | --samples: expected 1 to 1073741824, found -1",
        "render s.json -s 1.5           | 1.5",
        "render s.json -s 99999999999   | 99999999999",
        "render s.json -s 4 -s 5        | should be specified only once",
        "render s.json --depth -1       | --depth: expected 0 to 1000000, found -1",
        "render s.json --threads 1025   | --threads: expected 0 to 1024, found 1025",
        "render s.json --bucket 0       | --bucket: expected 1 to",
        "render s.json --seed x         | --seed",
        "render s.json --size 0x5       | --size: expected 1 to 65535, found 0",
        "render s.json --size 5x70000   | --size: expected 1 to 65535, found 70000",
        "render s.json --size 5x        | such as 640x480, or the longer side, such as 640,",
        "render s.json --size 70000     | --size: expected 1 to 65535, found 70000",
        "render s.json --size 0         | --size: expected 1 to 65535, found 0",
        "trade s.json --size 0x5        | --size: expected 1 to 65535, found 0",
        "render s.json --spp 4          | unknown option '--spp'; did you mean --samples N?",
        "render s.json --width 800      | '--width'; did you mean --size WxH?",
        "render s.json --height=600     | '--height=600'; did you mean --size WxH?",
        "render a.glb --hdri a.exr      | '--hdri'; did you mean --sky FILE?",
        "render a.glb --transparent     | '--transparent'; did you mean --background transparent?",
        "render a.glb --bg red          | '--bg'; did you mean --background COLOR?",
        "render a.glb --SIZE 8x8        | '--SIZE'; did you mean --size?",
        "check a.glb --size 8x8         | '--size'; --size is a flag of 'lumbre render', 'lumbre",
        "check a.glb --spp 8            | '--spp'; --samples is a flag of 'lumbre render', 'lumbre",
        "info a.glb                     | unknown command info; did you mean check?",
        "model.glb                      | model.glb; did you mean 'lumbre render model.glb'?",
        "Night.JSON -s 4                | did you mean 'lumbre render Night.JSON'?",
        "a.exr                          | unknown command a.exr; did you mean 'lumbre view a.exr'?",
        "render s.json --crop 1,2,3     | such as 100,50,64,48",
        "render s.json --crop 1,2,0,4   | crop width: expected 1 to 65535, found 0",
        "render s.json --size 8x8 --crop 4,4,5,4 | --crop: expected a part of 8x8, found 4,4,5,4",
        "render s.json --exposure NaN   | auto or a finite number of stops",
        "render s.json --exposure 1e400 | auto or a finite number of stops",
        "render s.json --exposure much  | auto or a finite number of stops",
        "render s.json --tonemap film   | one of srgb, gamma22, reinhard, aces",
        "render s.json --mode both      | one of ray, path",
        "render s.json --kernel fast    | one of auto, vector, scalar",
        "benchmark --kernel fast        | one of auto, vector, scalar",
        "render s.json --bits 12        | --bits: expected 8 or 16, found 12",
        "render s.json -o p.gif         | p.gif: requires --turntable, --animation, --explode A..B"
            + " or several scenes",
        "render s.json -o p.bmp         | p.bmp: expected a name that ends in one of .png",
        "render s.json -o s.json        | one of .png",
        "render s.json --strict --lenient | lumbre: --strict, --lenient are mutually exclusive",
        "render s.json --seed 1.5       | expected an integer up to 9223372036854775807, found"
            + " '1.5'",
        "render s.json --depth 3000000000 | expected an integer up to 2147483647, found"
            + " '3000000000'",
        "render s.json --clamp much     | expected a number, found 'much'",
        "compare a.png b.png --tolerance rmse=x | expected a number, found 'x'",
        "help nothing                   | 'nothing' (see",
        "check                          | SCENE",
        "check s.json -s 4              | -s",
      })
  void wrongCommandLinesAreExplainedInALine(String line, String message) {
    Outcome.of(line.split(" +")).assertFailed(ExitCodes.USAGE, message, "--help");
  }

  @Test
  void versionNamesProgramMachineAndSystem() {
    Outcome outcome = Outcome.of("--version").done();
    assertThat(outcome.out())
        .containsPattern("Lumbre \\d+\\.\\d+")
        .contains("JVM: ", "Kernel: ", "OS: ");
  }

  @ParameterizedTest
  @ValueSource(strings = {"render --help all", "render -h all"})
  void helpOnAllExplainsEveryFlagOfRender(String line) {
    Outcome outcome = Outcome.of(line.split(" ")).done();
    CommandLine command = Lumbre.commandLine().getSubcommands().get("render");
    for (OptionSpec flag : command.getCommandSpec().options()) {
      assertThat(outcome.out()).contains(" " + flag.longestName());
    }
    assertThat(outcome.out()).contains("Exit codes", "Examples");
  }

  @ParameterizedTest
  @ValueSource(strings = {"help render", "render --help", "render -h"})
  void helpFitsAScreenAndSaysWhereTheRestIs(String line) {
    Outcome outcome = Outcome.of(line.split(" ")).done();
    assertThat(outcome.out().lines()).hasSizeLessThanOrEqualTo(80);
    assertThat(outcome.out())
        .contains("--output", "--samples", "--size", "--view", "--background", "2%.", "Examples")
        .contains("lumbre render --help all")
        .doesNotContain("%%", "--crease");
  }

  /** Help lists what a command has; what it refuses, it refuses with the reason. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "diff a.obj b.obj  | --explode 0.5 | parts are compared where they are",
        "diff a.obj b.obj  | --camera a    | one camera, from --view, frames both models",
        "import a.obj      | --labels all  | a scene file holds no labels",
        "import a.obj      | --hidden dashed | does not hold which lines are hidden",
        "import a.obj      | --assets .    | only files in its own folder or below",
        "views a.obj -o a  | --view front  | renders all standard views",
        "views a.obj -o a  | --camera a    | renders all standard views",
        "views a.obj -o a  | --eye 1,2,3   | renders all standard views",
        "views a.obj -o a  | --target 0,0,0 | renders all standard views"
      })
  void helpListsNoFlagThatIsRefused(String command, String flag, String reason) {
    String name = flag.split(" ")[0];
    String help = Outcome.of(command.split(" ")[0], "--help", "all").done().out();
    assertThat(help).contains("\n      --look=").doesNotContain("\n      " + name);
    Outcome.of((command + " " + flag).split(" "))
        .assertFailed(ExitCodes.USAGE, name + ": cannot be used; ", reason);
  }

  @Test
  void theProgramAlonePrintsItsHelp() {
    Outcome outcome = Outcome.of();
    assertThat(outcome).isEqualTo(Outcome.of("help"));
    assertThat(outcome.exitCode()).isZero();
    assertThat(outcome.out()).contains("render", "Examples:");
  }

  @Test
  void completionKnowsCommandsAndFlags() {
    Outcome outcome = Outcome.of("completion").done();
    assertThat(outcome.out())
        .startsWith("# Completion for lumbre in bash and zsh: source <(lumbre completion)\n")
        .contains("render", "check", "--tonemap", "complete -o default -F");
  }

  @Test
  void everyCommandIsFoundByItsOwnName() {
    Lumbre.commandLine()
        .getSubcommands()
        .forEach((name, command) -> assertThat(command.getCommandName()).isEqualTo(name));
  }

  @Test
  void helpListsEveryCommandOnce() {
    String help = Outcome.of("--help").out();
    Lumbre.commandLine()
        .getSubcommands()
        .forEach(
            (name, command) -> {
              String header = command.getCommandSpec().usageMessage().header()[0];
              assertThat(help).containsOnlyOnce("\n  %-12s%s\n".formatted(name, header));
            });
  }

  @Test
  void noFlagUsesAnExcludedConverter() {
    List<String> excluded = new ArrayList<>();
    collectExcluded(Lumbre.commandLine(), excluded);
    assertThat(excluded).isEmpty();
  }

  private static void collectExcluded(CommandLine command, List<String> excluded) {
    for (ArgSpec arg : command.getCommandSpec().args()) {
      for (Class<?> type : arg.auxiliaryTypes()) {
        boolean isExcluded =
            Stream.of(Lumbre.EXCLUDED_CONVERTERS.split(",")).anyMatch(type.getName()::matches);
        // Durations have a converter of ours.
        if (arg.converters().length == 0 && isExcluded && type != Duration.class) {
          excluded.add(command.getCommandName() + ": " + arg);
        }
      }
    }
    command.getSubcommands().values().forEach(each -> collectExcluded(each, excluded));
  }

  @Test
  void flagsOfMixinsStandUnderTheirHeadings() {
    CommandLine command = Lumbre.commandLine().getSubcommands().get("render");
    Map<String, List<OptionSpec>> divided = HelpLayout.divided(command.getCommandSpec());
    assertThat(divided.values().stream().flatMap(List::stream))
        .containsExactlyInAnyOrderElementsOf(command.getCommandSpec().options());
    assertThat(names(divided.get(""))).contains("--output", "--help");
    assertThat(names(divided.get("Light transport"))).contains("--mode", "--split");
    assertThat(names(divided.get("Samples"))).contains("--samples", "--seed");
    assertThat(names(divided.get("Frame"))).contains("--size", "--crop");
  }

  private static List<String> names(List<OptionSpec> flags) {
    return flags.stream().map(OptionSpec::longestName).toList();
  }

  @ParameterizedTest
  @ValueSource(strings = {"--help", "help render", "render --help all", "trade --help all"})
  void helpFitsEightyColumns(String line) {
    assertThat(Outcome.of(line.split(" ")).out().lines()).allMatch(text -> text.length() <= 80);
  }

  /** The line breaker of the JDK takes the dot of {@code .exr} for the end of a sentence. */
  @Test
  void noHelpBreaksTheEndingOfAFileName() {
    Lumbre.commandLine()
        .getSubcommands()
        .keySet()
        .forEach(
            name ->
                assertThat(Outcome.of("help", name).out().lines())
                    .noneMatch(l -> l.endsWith(" .")));
  }

  @ParameterizedTest
  @CsvSource({"bench, lumbre perf"})
  void earlierNamesOfCommandsAnswerWithTheNewOnes(String former, String present) {
    Outcome outcome = Outcome.of(former, "--nonsense");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(outcome.err())
        .startsWith("warning: 'lumbre " + former + "' is now '" + present + "'\n")
        .contains("'" + present + " --help'");
    assertThat(Outcome.of("--help").out()).doesNotContain(former + " ");
  }
}
