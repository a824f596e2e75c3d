package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.lab.perf.RasterHash;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests pictures on standard output, scenes from standard input, and streams that cannot be
 * written.
 */
@DisabledOnOs(OS.WINDOWS)
class StandardStreamsIT {
  @TempDir private Path directory;

  @BeforeEach
  void writeScene() throws IOException {
    TinyScene.write(directory, TinyScene.JSON);
    Files.createDirectory(directory.resolve("other"));
  }

  /** Runs a shell command in which LUMBRE stands for the program. */
  private Outcome shell(String line) throws IOException, InterruptedException {
    String program = Program.lumbre().stream().collect(Collectors.joining("' '", "'", "'"));
    return Program.run(directory, List.of("sh", "-c", line.replace("LUMBRE", program)));
  }

  private byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(directory.resolve(name));
  }

  @ParameterizedTest
  @ValueSource(strings = {"check tiny.json", "help render", "render tiny.json --dry-run"})
  void anAnswerThatCannotBePrintedIsAnError(String command)
      throws IOException, InterruptedException {
    assumeTrue(Files.exists(Path.of("/dev/full")), "the system has no /dev/full");
    Outcome full = shell("LUMBRE " + command + " > /dev/full");
    assertThat(full.err()).contains("lumbre: standard output cannot be written: ").hasLineCount(1);
    assertThat(full.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(shell("LUMBRE " + command + " >&-").exitCode()).isEqualTo(ExitCodes.OUTPUT);
    Outcome pipe = shell("(LUMBRE " + command + "; echo code $? >&2) | true");
    assertThat(pipe.err()).isEqualTo("code 6\n");
  }

  @Test
  void otherFailuresKeepTheirCode() throws IOException, InterruptedException {
    assumeTrue(Files.exists(Path.of("/dev/full")), "the system has no /dev/full");
    assertThat(shell("LUMBRE check none.json --json > /dev/full").exitCode())
        .isEqualTo(ExitCodes.SCENE);
    assertThat(shell("LUMBRE render tiny.json --quiet > /dev/full").exitCode()).isZero();
  }

  @ParameterizedTest
  @CsvSource({"png, PNG", "exr, v/1", "pfm, PF", "jpg, JFIF"})
  void picturesGoToStandardOutput(String format, String magic)
      throws IOException, InterruptedException {
    Outcome outcome =
        shell("LUMBRE render tiny.json -o - --format " + format + " --fallback-dir other > p");
    assertThat(outcome.err()).startsWith("standard output: 16x12 pixels").hasLineCount(1);
    assertThat(outcome.exitCode()).isZero();
    String start = new String(bytes("p"), 0, 16, StandardCharsets.ISO_8859_1);
    assertThat(start).contains(magic);
    assertThat(directory.resolve("other")).isEmptyDirectory();
  }

  @Test
  void scenesComeFromStandardInput() throws IOException, InterruptedException {
    assertThat(shell("LUMBRE render - < tiny.json").err()).startsWith("stdin.png: 16x12 pixels");
    shell("LUMBRE render - -o - < tiny.json > piped.exr --format exr");
    shell("LUMBRE render tiny.json -o plain.exr");
    assertThat(pixels("piped.exr")).isEqualTo(pixels("plain.exr"));
    assertThat(shell("LUMBRE check - < tiny.json").out()).contains("is valid");
    assertThat(shell("LUMBRE audit - < tiny.json").exitCode()).isZero();
    assertThat(shell("LUMBRE pixel - 3,3 < tiny.json").exitCode()).isZero();
    assertThat(shell("echo '{}' | LUMBRE check -").err()).contains("stdin: $");
  }

  private String pixels(String name) throws IOException {
    return RasterHash.of(LinearReader.decode(bytes(name)));
  }

  @Test
  void assetsOfAPipedSceneAreProtected() throws IOException, InterruptedException {
    Files.copy(Path.of("renders", "cornell-box.png"), directory.resolve("wood.png"));
    byte[] wood = bytes("wood.png");
    String texture = "{\"id\": 8, \"assetType\": \"Texture\", \"file\": \"wood.png\"}";
    TinyScene.write(directory, TinyScene.withAsset(texture));
    Outcome outcome = shell("LUMBRE render - -o wood.png < tiny.json");
    assertThat(outcome.err()).contains("wood.png: is a file of the scene -");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(bytes("wood.png")).isEqualTo(wood);
  }

  @Test
  void theFileBehindStandardInputIsProtected() throws IOException, InterruptedException {
    assumeTrue(Files.exists(Path.of("/dev/stdin")), "the system has no /dev/stdin");
    Files.move(directory.resolve("tiny.json"), directory.resolve("tiny.png"));
    Outcome outcome = shell("LUMBRE render - -o tiny.png --overwrite < tiny.png");
    assertThat(outcome.err()).contains("tiny.png: is standard input");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(directory.resolve("tiny.png")).hasContent(TinyScene.JSON);
  }

  @Test
  void aPictureThatStandardOutputRefusesIsKept() throws IOException, InterruptedException {
    assumeTrue(Files.exists(Path.of("/dev/full")), "the system has no /dev/full");
    Outcome outcome = shell("LUMBRE render tiny.json -o - --fallback-dir other > /dev/full");
    assertThat(outcome.err()).contains("standard output cannot be written: ", "saved as other/");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(Folders.files(directory.resolve("other")))
        .hasSize(1)
        .allMatch(file -> file.toFile().length() > 0);
  }

  @Test
  void aPictureWithoutReaderIsKept() throws IOException, InterruptedException {
    Outcome outcome =
        shell("(LUMBRE render tiny.json -o - --fallback-dir other; echo code $? >&2) | true");
    assertThat(outcome.err())
        .contains("standard output cannot be written: ", "saved as other/", "code 6\n");
  }

  @ParameterizedTest
  @CsvSource({
    "render tiny.json --format exr, --format",
    "render tiny.json -o - --json, --json",
    "render tiny.json -o - --checkpoint a.film, --checkpoint",
    "render - --checkpoint a.film, --checkpoint",
    "render tiny.json --jpeg-quality 0, --jpeg-quality",
    "develop a.film -o a.jpg --jpeg-quality 101, --jpeg-quality"
  })
  void flagsThatDoNotFitAreRefused(String command, String part)
      throws IOException, InterruptedException {
    Outcome outcome = shell("LUMBRE " + command + " < tiny.json");
    assertThat(outcome.err()).contains(part).hasLineCount(1);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
  }

  @Test
  void aTerminalIsNoPlaceForAPicture() throws IOException, InterruptedException {
    Outcome outcome =
        shell("JAVA_TOOL_OPTIONS=-Dlumbre.stdout.tty=true LUMBRE render tiny.json -o -");
    assertThat(outcome.err()).contains("standard output is a terminal");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
  }

  /** A file size limit simulates a full disk in both places. */
  @Test
  void twoFullDisksLeaveNoEmptyFile() throws IOException, InterruptedException {
    Outcome outcome =
        shell(
            "ulimit -f 64; LUMBRE render tiny.json --size 300x300 -s 1 -o a.pfm"
                + " --checkpoint a.film --fallback-dir other 2> /dev/null");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(directory.resolve("other")).isEmptyDirectory();
    assertThat(Folders.names(directory))
        .containsExactlyInAnyOrder("tiny.json", "other", "out.txt", "err.txt");
  }
}
