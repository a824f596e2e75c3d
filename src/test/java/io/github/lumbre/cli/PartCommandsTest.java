package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the flags for parts of models. */
class PartCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 --view front --quiet";

  /** A gray square, and a red one to its right. */
  private static final String MODEL =
      """
      mtllib a.mtl
      v 0 0 0
      v 1 0 0
      v 1 1 0
      v 0 1 0
      v 2 0 0
      v 3 0 0
      v 3 1 0
      v 2 1 0
      o left
      usemtl gray
      f 1 2 3 4
      o right
      usemtl red
      f 5 6 7 8
      """;

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(directory.resolve("a.obj"), MODEL);
    Files.writeString(
        directory.resolve("a.mtl"), "newmtl gray\nKd .5 .5 .5\nnewmtl red\nKd 1 0 0\n");
  }

  @Test
  void hiddenPartsAreNotFramed() throws IOException {
    runs("render T/a.obj -o T/all.png" + SMALL);
    runs("render T/a.obj -o T/left.png --background #ffffff --hide right" + SMALL);
    BufferedImage left = ImageIO.read(directory.resolve("left.png").toFile());
    // The square fills the height alone.
    int background = left.getRGB(0, 9);
    assertThat(left.getRGB(12, 1)).isNotEqualTo(background);
    assertThat(left.getRGB(12, 16)).isNotEqualTo(background);
    assertThat(left.getRGB(23, 9)).isEqualTo(background);
    Files.writeString(directory.resolve("alone.obj"), MODEL.substring(0, MODEL.indexOf("o right")));
    runs("render T/alone.obj -o T/alone.png --background #ffffff" + SMALL);
    assertThat(pixels("left.png")).isEqualTo(pixels("alone.png"));
  }

  @Test
  void importedAndResumedPicturesHaveTheSameParts() {
    String flags = SMALL + " --no-denoise --highlight right --hide l*x --hide left --hide nope*";
    run("render T/a.obj -o T/no.png" + flags)
        .assertFailed(ExitCodes.ASSET, "--hide: expected \"left\" or \"right\", found \"l*x\"");
    flags = SMALL + " --no-denoise --highlight right";
    runs("render T/a.obj -o T/a.png -s 4" + flags);
    runs("import T/a.obj -o T/scene.json --view front --highlight right");
    runs("render T/scene.json -o T/b.png -s 4 --size 24x18 --quiet");
    runs("render T/a.obj -o T/c.png -s 2 --checkpoint T/a.film" + flags);
    runs("resume T/a.film -s 4 -o T/d.png --quiet");
    assertThat(pixels("b.png")).isEqualTo(pixels("a.png"));
    assertThat(pixels("d.png")).isEqualTo(pixels("a.png"));
    runs("render T/a.obj -o T/e.png -s 4 --no-denoise" + SMALL);
    assertThat(pixels("e.png")).isNotEqualTo(pixels("a.png"));
  }

  @Test
  void namesOfPartsInScenesAreTextsInArrays() throws IOException {
    for (String value : new String[] {"\"left\"", "[1]"}) {
      Files.writeString(
          directory.resolve("scene.json"),
          "{\"objects\": [{\"type\": \"Model\", \"file\": \"a.obj\", \"hide\": " + value + "}]}");
      String expected =
          value.equals("[1]") ? "[0]: expected a string, found 1" : ": expected an array";
      Outcome outcome = run("check T/scene.json");
      assertThat(outcome.exitCode()).isEqualTo(ExitCodes.SCENE);
      assertThat(outcome.err()).contains("$.objects[0].hide" + expected);
    }
  }

  @Test
  void viewsAndTurntablesHideParts() {
    runs("views T/a.obj -o T/views --size 24x18 -s 1 --no-denoise --hide right");
    runs("render T/a.obj -o T/front.png -s 1 --no-denoise --hide right" + SMALL);
    assertThat(pixels("views/front.png")).isEqualTo(pixels("front.png"));
    String transparent = " --background transparent --no-denoise -s 1 --hide left";
    runs("render T/a.obj -o T/t.png --turntable 2" + SMALL + transparent);
    runs("render T/a.obj -o T/u.png" + SMALL + transparent);
    assertThat(pixels("t-000.png")[9 * 24 + 12]).isNotZero();
    assertThat(pixels("t-000.png")[9 * 24]).isZero();
  }

  @Test
  void flagsForPartsNeedAModel() throws IOException {
    Files.writeString(directory.resolve("scene.json"), "{}");
    run("render T/scene.json --hide left")
        .assertFailed(ExitCodes.USAGE, "--hide: requires a model file");
    run("check T/a.obj --highlight rigth")
        .assertFailed(ExitCodes.ASSET, "--highlight: ", "found \"rigth\"; did you mean right?");
  }
}
