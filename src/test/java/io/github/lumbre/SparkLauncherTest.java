package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code spark/lumbre-spark} in a copy of the project whose build takes 11 s and fails. */
@DisabledOnOs(OS.WINDOWS)
class SparkLauncherTest {
  @TempDir private Path home;

  @Test
  void longBuildIsNotSilent() throws Exception {
    Path script = home.resolve("spark/lumbre-spark");
    Files.createDirectories(script.getParent());
    Files.copy(Path.of("spark/lumbre-spark"), script);
    Path build = Files.writeString(home.resolve("mvnw"), "#!/bin/sh\nsleep 11\nexit 1\n");
    assertThat(script.toFile().setExecutable(true)).isTrue();
    assertThat(build.toFile().setExecutable(true)).isTrue();
    Path err = home.resolve("err.txt");
    Process process = new ProcessBuilder(script.toString()).redirectError(err.toFile()).start();
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).isEqualTo(7);
    assertThat(Files.readAllLines(err))
        .containsExactly(
            "lumbre-spark: building, and downloading Spark (220 MB) if it is not there yet...",
            "lumbre-spark: still building, 10 s; the first start takes minutes",
            "lumbre-spark: the build failed");
  }
}
