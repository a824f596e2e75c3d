package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.ExitCode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Runs the commands of {@code docs/headless.md} that need neither a container nor JBang. */
class HeadlessPageTest {
  private static final String PROGRAM = "./lumbre ";

  @TempDir private Path folder;

  static List<String> commands() throws Exception {
    List<String> commands =
        Files.readAllLines(Path.of("docs", "headless.md")).stream()
            .filter(line -> line.startsWith(PROGRAM))
            .map(line -> line.replaceFirst(" +#.*", "").substring(PROGRAM.length()))
            .toList();
    assertThat(commands).hasSizeGreaterThan(3);
    return commands;
  }

  @ParameterizedTest
  @MethodSource("commands")
  void commandsDoWhatThePageSays(String command) throws Exception {
    List<String> words = new ArrayList<>(List.of(command.split(" ")));
    List<Path> written = new ArrayList<>();
    for (int i = 1; i < words.size(); i++) {
      if (List.of("-o", "--sheet").contains(words.get(i - 1))) {
        written.add(folder.resolve(words.get(i)));
        words.set(i, String.valueOf(folder.resolve(words.get(i))));
      }
    }
    Outcome outcome = Outcome.of(words.toArray(String[]::new));
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCode.OK.number());
    for (Path file : written) {
      assertThat(file).isNotEmptyFile();
    }
  }
}
