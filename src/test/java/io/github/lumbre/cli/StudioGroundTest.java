package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of models have an even ground behind them, without the lamps of the studio. */
class StudioGroundTest extends CommandFixture {
  private static final String SMALL = " --size 48x40 -s 2 --no-denoise";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  /** Checks that the first column falls from the top to the bottom, by at most 30 steps. */
  private void assertEven(String name) {
    assertEven(name, picture(name).getHeight());
  }

  /** Checks the upper rows of the first column. */
  private void assertEven(String name, int rows) {
    BufferedImage picture = picture(name);
    int brightest = picture.getRGB(0, 0) & 0xff;
    int last = brightest;
    int darkest = brightest;
    for (int y = 0; y < rows; y++) {
      int color = picture.getRGB(0, y);
      int blue = color & 0xff;
      assertThat(color >> 16 & 0xff).as("gray").isEqualTo(blue);
      // Dithered by a step.
      assertThat(blue).as(name + " in row " + y).isBetween(darkest - 3, darkest + 1);
      darkest = Math.min(darkest, blue);
      last = blue;
    }
    assertThat(brightest - last).isBetween(5, 30);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " --view front", " --view 200,-30", " --sky-rotation 170"})
  void theCameraSeesNoLamps(String flags) {
    runs("render T/sample.glb -o T/a.png" + flags + SMALL);
    assertEven("a.png");
  }

  @Test
  void noStandardViewSeesLamps() {
    runs("views T/sample.glb -o T/v --size 48x40 -s 2 --no-denoise");
    for (String view : List.of("front", "back", "left", "right", "top", "bottom")) {
      assertEven("v/" + view + ".png");
    }
    // Below, the contact shadow reaches the edge of the frame.
    assertEven("v/iso.png", 25);
  }

  /** The other backgrounds stay, and that of the sky shows the studio. */
  @Test
  void theSkyIsShownWhereItIsAskedFor() {
    String front = "render T/sample.glb --view 0,-40 -o T/";
    runs(front + "sky.png --background sky" + SMALL);
    runs(front + "white.png --sky white" + SMALL);
    BufferedImage sky = picture("sky.png");
    BufferedImage white = picture("white.png");
    int lamp = 0;
    for (int x = 0; x < sky.getWidth(); x++) {
      lamp = Math.max(lamp, sky.getRGB(x, 0) & 0xff);
    }
    assertThat(lamp).isGreaterThan(180);
    int last = white.getHeight() - 1;
    assertThat(white.getRGB(0, 0) & 0xff).isCloseTo(white.getRGB(0, last) & 0xff, within(1));
  }

  @Test
  void partsAndImportedScenesHaveTheSamePixels() {
    runs("render T/sample.glb -o T/whole.png" + SMALL);
    runs("render T/sample.glb -o T/part.png --crop 5,9,20,13" + SMALL);
    BufferedImage whole = picture("whole.png");
    BufferedImage part = picture("part.png");
    for (int y = 0; y < 13; y++) {
      for (int x = 0; x < 20; x++) {
        assertThat(part.getRGB(x, y)).isEqualTo(whole.getRGB(5 + x, 9 + y));
      }
    }
    runs("import T/sample.glb -o T/a.json");
    runs("render T/a.json -o T/scene.png" + SMALL);
    assertThat(pixels("scene.png")).isEqualTo(pixels("whole.png"));
  }

  @Test
  void aResumedRenderHasTheSameGround() {
    runs("render T/sample.glb -o T/whole.png" + SMALL);
    runs("render T/sample.glb -o T/one.png --checkpoint T/a.film --size 48x40 -s 1");
    runs("resume T/a.film -s 2 -o T/two.png");
    assertThat(pixels("two.png")).isEqualTo(pixels("whole.png"));
  }
}
