package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.cli.option.Choices;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.OptionSpec;

/** Runs the completion scripts in bash and fish. */
class CompletionTest {
  /** What a shell would do: the kind of the answer, then the words. */
  private static final String COMPLETE =
      """
      compopt() { if [ "$1" = +o ]; then echo "no files"; fi; }
      . ./lumbre.bash
      COMP_WORDS=("$@")
      COMP_CWORD=$(($# - 1))
      _lumbre
      echo "${COMPREPLY[*]}"
      """;

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "re                           | render resume",
        "help re                      | render resume",
        "render --tone                | --tonemap",
        "render --mode ''             | ray path",
        "render --mode = p            | path",
        "render --mode=p              | --mode=path",
        "render --quality ''          | draft preview final reference",
        "render --kernel ''           | auto vector scalar",
        "render --denoiser ''         | builtin oidn",
        "render --tonemap a           | aces agx",
        "render --guide ''            | off on",
        "render --layers al           | all albedo",
        "render --layers depth,al     | depth,all depth,albedo",
        "render --up ''               | y z",
        "render --view b              | back bottom",
        "render --samples ''          | ''",
        "develop night.film --tonemap s | srgb",
        "selftest ''                  | ''",
      })
  void wordsAreThoseThatTheCommandTakes(String line, String words) throws Exception {
    assertThat(answer(line)).containsExactly("no files", words);
  }

  /** Without an answer, the shell offers file names. */
  @ParameterizedTest
  @CsvSource({
    "render ''",
    "render --guide on ''",
    "render -o ''",
    "render --output = pic",
    "render --checkpoint ''",
    "compare a.png ''"
  })
  void filesAreLeftToTheShell(String line) throws Exception {
    assertThat(answer(line)).containsExactly("");
  }

  @Test
  void skiesAreNamesAndFiles() throws Exception {
    Files.createFile(folder.resolve("studio room.hdr"));
    assertThat(answer("render --sky st")).containsExactly("studio studio room.hdr");
  }

  @Test
  void commandsTakeFilesOfTheirKindAndFolders() throws Exception {
    for (String name : List.of("a.json", "a b.glb", "a.png", "a.film", "a.exr")) {
      Files.createFile(folder.resolve(name));
    }
    Files.createDirectory(folder.resolve("a.d"));
    assertThat(words("render a")).containsExactlyInAnyOrder("a", "b.glb", "a.d", "a.json");
    assertThat(words("views a")).containsExactlyInAnyOrder("a", "b.glb", "a.d");
    assertThat(words("resume a")).containsExactlyInAnyOrder("a.d", "a.film");
    assertThat(words("render --sky a")).contains("a.png", "a.exr", "a.film");
    assertThat(answer("render x.json -o a")).containsExactly("");
  }

  @Test
  void everyNameIsAccepted() throws Exception {
    for (CommandLine command : Lumbre.commandLine().getSubcommands().values()) {
      for (OptionSpec option : command.getCommandSpec().options()) {
        Optional<Choices> choices = Completion.choices(option);
        if (choices.isPresent()) {
          for (String name : choices.get().choices()) {
            assertThat(((ITypeConverter<?>) choices.get()).convert(name)).isNotNull();
          }
        }
      }
    }
  }

  private List<String> words(String line) throws IOException, InterruptedException {
    return List.of(answer(line).get(0).split(" "));
  }

  private List<String> answer(String line) throws IOException, InterruptedException {
    assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "needs bash");
    Files.writeString(folder.resolve("lumbre.bash"), Outcome.of("completion").out());
    Path script = Files.writeString(folder.resolve("complete"), COMPLETE);
    ProcessBuilder bash = new ProcessBuilder("/bin/bash", script.toString(), "lumbre");
    for (String word : line.split(" ")) {
      bash.command().add(word.equals("''") ? "" : word);
    }
    Process process = bash.directory(folder.toFile()).redirectErrorStream(true).start();
    String answer = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).isZero();
    return answer.lines().toList();
  }

  /** What fish offers after a line, without the descriptions. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "lumbre re                       | render resume",
        "lumbre help re                  | render resume",
        "lumbre render --mode            | path ray",
        "lumbre render --layers depth,al | depth,albedo depth,all",
        "lumbre render --tonem           | --tonemap",
        "lumbre completion --shell f     | fish",
      })
  void fishOffersTheSame(String line, String words) throws Exception {
    Path fish = Path.of("/usr/bin/fish");
    assumeTrue(Files.isExecutable(fish), "needs fish");
    String script = Outcome.of("completion", "--shell", "fish").out();
    Files.writeString(folder.resolve("lumbre.fish"), script);
    String open = line.endsWith("--mode") ? line + " " : line;
    String command = "source lumbre.fish; complete -C '" + open + "'";
    ProcessBuilder shell = new ProcessBuilder(fish.toString(), "--no-config", "-c", command);
    shell.directory(folder.toFile()).redirectErrorStream(true);
    shell.environment().put("HOME", folder.toString());
    Process process = shell.start();
    process.getOutputStream().close();
    String answer = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    String found = answer.lines().map(l -> l.split("\t")[0]).sorted().collect(joining(" "));
    assertThat(found).isEqualTo(words);
  }

  /** PowerShell is not run: the tables have every command and flag, and quotes are closed. */
  @Test
  void powerShellHasEveryFlag() {
    String script = Outcome.of("completion", "--shell", "powershell").out();
    Lumbre.commandLine()
        .getSubcommands()
        .forEach(
            (name, command) -> {
              String start = "\n    '" + name + "' = @{\n";
              assertThat(script).contains(start);
              String table = script.substring(script.indexOf(start)).split("\n    }", 2)[0];
              for (OptionSpec option : command.getCommandSpec().options()) {
                assertThat(table.contains("'" + option.longestName() + "'"))
                    .as(option.longestName())
                    .isEqualTo(!option.hidden());
              }
            });
    for (String line : script.lines().toList()) {
      assertThat(line.chars().filter(c -> c == '\'').count() % 2).as(line).isZero();
    }
  }
}
