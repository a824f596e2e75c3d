package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the flags that show the shape of models alone. */
class LookCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 40x30 --view front --quiet";
  private static final int WHITE = 0xffffffff;

  /** A red square that fills the height of the picture, and glows. */
  private static final String MODEL =
      """
      mtllib a.mtl
      v 0 0 0
      v 1 0 0
      v 1 1 0
      v 0 1 0
      usemtl red
      f 1 2 3 4
      """;

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(directory.resolve("a.obj"), MODEL);
    Files.writeString(directory.resolve("a.mtl"), "newmtl red\nKd 1 0 0\nKe 5 0 0\n");
  }

  /** Returns how many pixels of the middle row are not white, as areas of black. */
  private static double darkness(BufferedImage image) {
    double dark = 0;
    for (int x = 0; x < image.getWidth(); x++) {
      double encoded = (image.getRGB(x, 15) & 0xff) / 255.;
      dark += 1 - (encoded < .04 ? encoded / 12.92 : Math.pow((encoded + .055) / 1.055, 2.4));
    }
    return dark;
  }

  @ParameterizedTest
  @CsvSource({"1.5", "1", "3"})
  void linesAreBlackOnWhite(double width) {
    runs("render T/a.obj -o T/a.png --look lines --line-width " + width + SMALL);
    BufferedImage image = picture("a.png");
    assertThat(image.getRGB(20, 15)).isEqualTo(WHITE);
    assertThat(image.getRGB(1, 15)).isEqualTo(WHITE);
    // Two borders; 0.02 is what rounding to bytes leaves of four partly covered pixels.
    assertThat(darkness(image)).isBetween(2 * width - .02, 2 * width + .02);
  }

  @Test
  void linesAreOnTransparentBackgrounds() {
    runs("render T/a.obj -o T/a.png --look lines --background transparent" + SMALL);
    BufferedImage image = picture("a.png");
    assertThat(image.getRGB(1, 15) >>> 24).isZero();
    assertThat(image.getRGB(20, 15)).isEqualTo(WHITE);
    // Each border covers a pixel by at least a half: black with alpha.
    assertThat(IntStream.range(0, 40).map(x -> image.getRGB(x, 15)))
        .anyMatch(pixel -> (pixel & 0xffffff) == 0 && pixel >>> 24 > 0x70);
  }

  @Test
  void clayIsGrayAndDoesNotGlow() {
    runs("render T/a.obj -o T/a.png --look clay" + SMALL);
    int gray = picture("a.png").getRGB(20, 15);
    int red = gray >> 16 & 0xff;
    assertThat(red).isBetween(100, 245);
    assertThat(Math.abs(red - (gray & 0xff))).isLessThan(12);
    assertThat(picture("a.png").getRGB(1, 15)).isEqualTo(WHITE);
    runs("render T/a.obj -o T/both.png --look clay,lines" + SMALL);
    assertThat(picture("both.png").getRGB(20, 15)).isEqualTo(gray);
    assertThat(darkness(picture("both.png"))).isGreaterThan(darkness(picture("a.png")) + 1);
  }

  @Test
  void aFilmDrawsTheLinesWhenItIsResumed() {
    String look = " --look clay,lines -s 2 --size 40x30 --view front";
    runs("render T/a.obj -o T/direct.png --no-denoise" + look);
    runs("render T/a.obj -o T/a.png --checkpoint T/a.film" + look);
    assertThat(runs("develop T/a.film -o T/plain.png").err())
        .contains("its picture has lines, which a film does not hold; 'lumbre resume' draws them");
    assertThat(darkness(picture("plain.png"))).isLessThan(darkness(picture("a.png")) - 1);
    runs("resume T/a.film -o T/resumed.png --overwrite");
    for (int x = 0; x < 40; x++) {
      assertThat(picture("a.png").getRGB(x, 15)).isEqualTo(picture("direct.png").getRGB(x, 15));
      assertThat(picture("resumed.png").getRGB(x, 15)).isEqualTo(picture("a.png").getRGB(x, 15));
    }
  }

  @Test
  void importedScenesHaveTheLook() throws IOException {
    String look = " --look lines --line-width 2 --crease 10 --view front";
    runs("import T/a.obj -o T/a.json" + look);
    assertThat(Files.readString(directory.resolve("a.json")))
        .contains("\"lineWidth\": 2", "\"creaseAngle\": 10", "\"look\": \"white\"");
    runs("render T/a.json -o T/scene.png --size 40x30 -s 2");
    runs("render T/a.obj -o T/a.png --no-denoise --size 40x30 -s 2" + look);
    for (int x = 0; x < 40; x++) {
      assertThat(picture("scene.png").getRGB(x, 15)).isEqualTo(picture("a.png").getRGB(x, 15));
    }
  }

  @Test
  void viewsHaveLines() {
    runs("views T/a.obj -o T/views --look lines --size 40x30");
    assertThat(darkness(picture("views/front.png"))).isBetween(2.98, 3.02);
    assertThat(directory.resolve("views/views.png")).exists();
  }

  @Test
  void numberOfThreadsDoesNotMatter() {
    String render = "render T/a.obj --look clay,lines --no-denoise -s 2" + SMALL + " -o T/";
    runs(render + "1.pfm --threads 1");
    runs(render + "3.pfm --threads 3");
    assertThat(directory.resolve("1.pfm")).hasSameBinaryContentAs(directory.resolve("3.pfm"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--look wood | --look: expected clay, lines or clay,lines, found wood",
        "--look lines, | --look: expected clay, lines or clay,lines, found lines,",
        "--line-width 2 | --line-width: requires --look lines or clay,lines",
        "--crease 2 --look clay | --crease: requires --look lines or clay,lines",
        "--look lines --line-width 101 | --line-width: expected a number in (0, 100], found 101",
        "--look lines --line-width 0 | --line-width: expected a number in (0, 100], found 0.0",
        "--look lines --crease -1 | --crease: expected a number from 0 to 180, found -1",
        "--look lines --ground | --ground: cannot be combined with --look lines, which has no"
            + " shadows"
      })
  void wrongFlagsAreErrors(String flags, String message) {
    Outcome outcome = run("render T/a.obj -o T/a.png " + flags);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(outcome.err()).contains(message);
  }

  @Test
  void missingLinesAreReported() throws IOException {
    Files.writeString(directory.resolve("points.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n");
    assertThat(runs("render T/points.obj --look lines --size 8x6 -o T/a.png").err())
        .contains("points.obj: lines: 1 of 1 shapes have no lines, because only meshes have edges");
    for (String type : new String[] {"FishEye", "Pinhole"}) {
      Files.writeString(
          directory.resolve("a.json"),
          """
          {"mainCameraId": 1, "renderOptions": {"lineWidth": 1},
           "objects": [
             {"id": 1, "type": "Camera", "cameraType": "%s"},
             {"type": "Shape", "shapeType": "Plane"},
             {"type": "Shape", "shapeType": "Sphere"}]}
          """
              .formatted(type));
      String expected =
          type.equals("Pinhole")
              ? "1 of 2 shapes have no lines, because only meshes have edges"
              : "draws no lines, because the camera bends straight lines";
      assertThat(runs("check T/a.json").err()).contains("$.renderOptions.lineWidth: " + expected);
    }
  }
}
