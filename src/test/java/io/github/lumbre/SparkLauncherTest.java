package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests {@code spark/lumbre-spark} in a copy of the project whose build fails after a while. Time
 * passes five times as fast as the launcher thinks.
 */
@DisabledOnOs(OS.WINDOWS)
class SparkLauncherTest {
  @TempDir private Path home;

  @Test
  void longBuildIsNotSilent() throws Exception {
    Path script = home.resolve("spark/lumbre-spark");
    Files.createDirectories(script.getParent());
    Files.copy(Path.of("spark/lumbre-spark"), script);
    Path build = Files.writeString(home.resolve("mvnw"), "#!/bin/sh\n/bin/sleep 3\nexit 1\n");
    Path sleep =
        Files.writeString(
            home.resolve("sleep"), "#!/bin/sh\n[ \"$1\" = 10 ] && exec /bin/sleep 2\n");
    for (Path program : List.of(script, build, sleep)) {
      assertThat(program.toFile().setExecutable(true)).isTrue();
    }
    Path err = home.resolve("err.txt");
    ProcessBuilder builder = new ProcessBuilder(script.toString()).redirectError(err.toFile());
    builder.environment().merge("PATH", home + ":", (path, first) -> first + path);
    Process process = builder.start();
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).isEqualTo(7);
    assertThat(Files.readAllLines(err))
        .containsExactly(
            "lumbre-spark: building, and downloading Spark (220 MB) if it is not there yet...",
            "lumbre-spark: still building, 10 s; the first start takes minutes",
            "lumbre-spark: the build failed");
  }

  /** Tests take longer to compile than what Spark needs. */
  @Test
  void theBuildLeavesOutTests() throws Exception {
    Path script = home.resolve("spark/lumbre-spark");
    Files.createDirectories(script.getParent());
    Files.copy(Path.of("spark/lumbre-spark"), script);
    Path build = Files.writeString(home.resolve("mvnw"), "#!/bin/sh\necho \"$@\" >>calls.txt\n");
    for (Path program : List.of(script, build)) {
      assertThat(program.toFile().setExecutable(true)).isTrue();
    }
    Process process =
        new ProcessBuilder(script.toString())
            .redirectErrorStream(true)
            .redirectOutput(home.resolve("out.txt").toFile())
            .start();
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(Files.readAllLines(home.resolve("calls.txt")))
        .hasSize(2)
        .allSatisfy(line -> assertThat(line).contains("-Dmaven.test.skip=true"));
  }
}
