package io.github.lumbre.cli;

import static org.junit.jupiter.api.Assumptions.assumeFalse;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Every command reports why a file cannot be read. */
@DisabledOnOs(OS.WINDOWS)
class UnreadableFilesTest {
  @TempDir private Path directory;

  /** A command line with the placeholder {@code FILE}, and the expected exit code. */
  static Stream<Arguments> readers() {
    return Stream.of(
        Arguments.of("render FILE -o OUT", ExitCodes.SCENE),
        Arguments.of("check FILE", ExitCodes.SCENE),
        Arguments.of("audit FILE", ExitCodes.SCENE),
        Arguments.of("pixel FILE 0,0", ExitCodes.SCENE),
        Arguments.of("trade FILE -o PAGE", ExitCodes.SCENE),
        Arguments.of("develop FILE -o OUT", ExitCodes.SCENE),
        Arguments.of("merge FILE FILE -o OUT", ExitCodes.SCENE),
        Arguments.of("compare FILE FILE", ExitCodes.USAGE));
  }

  private Outcome run(String command, Path file) {
    return Outcome.of(
        command
            .replace("FILE", file.toString())
            .replace("OUT", directory.resolve("out.png").toString())
            .replace("PAGE", directory.resolve("out.html").toString())
            .split(" "));
  }

  @ParameterizedTest
  @MethodSource("readers")
  void folders(String command, int code) {
    run(command, directory).assertFailed(code, directory.toString(), ": is a directory");
  }

  @ParameterizedTest
  @MethodSource("readers")
  void filesThatMayNotBeRead(String command, int code) throws IOException {
    Path file = Files.writeString(directory.resolve("secret"), "{}");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---------"));
    assumeFalse(Files.isReadable(file), "this user may read every file");
    run(command, file).assertFailed(code, file.toString(), ": permission denied");
  }

  @Test
  void textsThatAreNot() throws IOException {
    Files.write(directory.resolve("table.csv"), "ä".getBytes(StandardCharsets.ISO_8859_1));
    run("benchmark --scenes FILE", directory)
        .assertFailed(ExitCodes.USAGE, "table.csv: cannot be read: not UTF-8 text");
  }
}
