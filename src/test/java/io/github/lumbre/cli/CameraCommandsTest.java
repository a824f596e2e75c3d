package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.awt.image.BufferedImage;
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

  /** A round disk with a vertical wall between round edges. */
  private static String disk() {
    int sides = 90;
    int rings = 12;
    StringBuilder obj = new StringBuilder();
    for (int ring = 0; ring < rings; ring++) {
      double angle = Math.PI / 2 - Math.PI * (ring - (ring < rings / 2 ? 0 : 1)) / (rings - 2);
      double height = (ring < rings / 2 ? .5 : -.5) + .3 * Math.sin(angle);
      double radius = .7 + .3 * Math.cos(angle);
      for (int i = 0; i < sides; i++) {
        double turn = 2 * Math.PI * i / sides + .1;
        // The wall is vertical but for rounding.
        double r = radius * (1 + (ring < rings / 2 ? 0 : 1e-15 * (i % 5 - 2)));
        obj.append("v " + r * Math.cos(turn) + " " + height + " " + r * Math.sin(turn) + "\n");
      }
    }
    for (int ring = 0; ring + 1 < rings; ring++) {
      for (int i = 0; i < sides; i++) {
        int next = (i + 1) % sides;
        int low = ring * sides + 1;
        obj.append("f " + (low + i) + " " + (low + next) + " ");
        obj.append(low + sides + next + " " + (low + sides + i) + "\n");
      }
    }
    return obj.toString();
  }

  /** The outline of a wall along the view has no gaps: 92 % of the frame are its diameter. */
  @Test
  void wallsAlongTheViewHaveAnOutline() throws IOException {
    Files.writeString(directory.resolve("disk.obj"), disk());
    runs(
        "render T/disk.obj -o T/disk.png --look lines --view top --size 120x120 -s 1 --no-denoise"
            + " --line-width 2 --quiet");
    BufferedImage picture = picture("disk.png");
    for (int i = 0; i < 360; i++) {
      double angle = Math.toRadians(i);
      int x = (int) (60 + .46 * 120 * Math.cos(angle));
      int y = (int) (60 + .46 * 120 * Math.sin(angle));
      int darkest = 255;
      for (int step = 0; step < 9; step++) {
        darkest = Math.min(darkest, picture.getRGB(x - 1 + step % 3, y - 1 + step / 3) & 255);
      }
      assertThat(darkest).as("at %s degrees", i).isLessThan(128);
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
