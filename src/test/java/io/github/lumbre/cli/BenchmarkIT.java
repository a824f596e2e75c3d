package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the benchmark's launcher in a copy of the built project. */
@DisabledOnOs(OS.WINDOWS)
class BenchmarkIT {
  @TempDir private Path directory;

  @Test
  void tableIsThatOfTheScenesBesideTheLauncher() throws IOException, InterruptedException {
    Path home = Files.createDirectories(directory.resolve("home of lumbre"));
    Program.copyOptions(home);
    Files.writeString(home.resolve("pom.xml"), "");
    for (String launcher : List.of("lumbre", "benchmark")) {
      Files.copy(Path.of(launcher), home.resolve(launcher));
      assertThat(home.resolve(launcher).toFile().setExecutable(true)).isTrue();
    }
    TinyTable.write(home.resolve("scenes"));
    Program.copyJars(home);
    Path link = Files.createSymbolicLink(directory.resolve("link"), home.resolve("benchmark"));

    Outcome outcome = Program.run(directory, List.of(link.toString(), "--rows", "3", "--check"));
    assertThat(outcome.out()).contains("| 3 | First | 16x12 | 3 of 300 |");
    assertThat(outcome.err()).contains("no hash is stored").hasLineCount(1);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.DIFFERENT);
  }
}
