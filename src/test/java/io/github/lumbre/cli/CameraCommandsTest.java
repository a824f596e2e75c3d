package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The flags of cameras before models. */
class CameraCommandsTest extends CommandFixture {
  private static final String MODEL =
      "v 0 0 0\nv 6 0 0\nv 0 4 0\nv 0 0 2\no base\nf 1 3 2\nf 1 2 4\no side\nf 1 4 3\nf 2 3 4\n";

  private static final String SMALL = " --size 24x18 -s 1 --no-denoise --quiet";

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(directory.resolve("a.obj"), MODEL);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--eye 1,2,3 --view front    | --eye and --view: expected only one of them",
        "--eye 1,2,3 --camera a      | --camera and --eye: expected only one of them",
        "--camera a --view front     | --camera and --view: expected only one of them",
        "--camera a --fit base       | --camera and --fit: expected only one of them",
        "--camera a --parallel       | --camera and --parallel: expected only one of them",
        "--parallel --perspective    | --parallel and --perspective: expected only one of them",
        "--view iso --parallel --fov 9 | --parallel and --fov: expected only one of them",
        "--target 1,2,3              | --target: requires --eye; --fit puts a part",
        "--eye 1,2,3 --target 1,2,3.0 | expected two different points, found 1,2,3 for both",
        "--fit nothing               | fit: expected \"base\" or \"side\", found \"nothing\"",
        "--eye 3,2,1                 | move --eye away, or state --target",
        "--turntable 2 --eye 1,2,3   | --turntable: cannot be combined with --eye",
      })
  void contradictionsSayWhatToDo(String flags, String message) {
    Outcome outcome = run("render T/a.obj -o T/a.png " + flags + SMALL);
    outcome.assertFailed(ExitCodes.USAGE, message);
    assertThat(directory.resolve("a.png")).doesNotExist();
  }

  @ParameterizedTest
  @ValueSource(strings = {"1e308", "-1e308", "NaN", "0", "Infinity", "1,2", "1,NaN,3", "1e101,0,0"})
  void pointsAreInTheirRange(String value) {
    for (String flag : new String[] {"--eye", "--target"}) {
      run("render T/a.obj -o T/a.png " + flag + "=" + value + SMALL)
          .assertFailed(
              ExitCodes.USAGE, flag + ": expected X,Y,Z, each a number from -1e100 to 1e100");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"1e308", "-1e308", "NaN", "0", "Infinity", "-1"})
  void zoomIsInItsRange(String value) {
    run("render T/a.obj -o T/a.png --zoom=" + value + SMALL)
        .assertFailed(ExitCodes.USAGE, "--zoom: expected a number from 1e-6 to 1000000");
  }

  /** A standard view in perspective is the same as its angles; without a flag it is not. */
  @Test
  void perspectiveIsThatOfTheAngles() throws IOException {
    byte[] angles = shown("--view 0,0");
    assertThat(shown("--view front --perspective")).isEqualTo(angles);
    assertThat(shown("--view front --fov 35")).isEqualTo(angles);
    assertThat(shown("--view front")).isNotEqualTo(angles);
    assertThat(shown("--view 0,0 --parallel")).isEqualTo(shown("--view front"));
    assertThat(shown("--fit * --view front")).isEqualTo(shown("--view front"));
    assertThat(shown("--zoom 2 --view front")).isNotEqualTo(shown("--view front"));
  }

  private byte[] shown(String flags) throws IOException {
    runs("render T/a.obj -o T/a.pfm --overwrite " + flags + SMALL);
    return Files.readAllBytes(directory.resolve("a.pfm"));
  }

  /** An imported scene has the parallel camera, and so the picture. */
  @Test
  void importKeepsTheCamera() throws IOException {
    for (String flags : new String[] {"--view iso", "--eye 9,8,7 --parallel", "--fit side"}) {
      runs("import T/a.obj --overwrite -o T/a.json " + flags);
      byte[] direct = shown(flags);
      runs("render T/a.json --overwrite -o T/b.pfm --size 24x18 -s 1 --no-denoise --quiet");
      Path imported = directory.resolve("b.pfm");
      assertThat(Files.readAllBytes(imported)).as(flags).isEqualTo(direct);
    }
  }

  @Test
  void viewsHaveTheirOwnPlaces() {
    for (String flag : new String[] {"--eye 1,2,3", "--target 1,2,3"}) {
      run("views T/a.obj -o T/v " + flag)
          .assertFailed(ExitCodes.USAGE, flag.split(" ")[0] + ": cannot be used");
    }
  }

  @Test
  void differencesAreSeenFromAnEye() throws IOException {
    Files.writeString(directory.resolve("b.obj"), MODEL.replace("v 0 4 0", "v 0 5 0"));
    Outcome outcome =
        run("diff T/a.obj T/b.obj -o T/d.html --size 32x24 --eye 20,10,30 --parallel");
    assertThat(outcome.exitCode()).isEqualTo(1);
    assertThat(directory.resolve("d.html")).exists();
  }
}
