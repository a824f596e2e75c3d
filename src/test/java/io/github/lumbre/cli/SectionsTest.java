package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Commands cut models by planes. */
class SectionsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 2 --seed 3 --quiet --no-denoise";

  /** The faces of a box, counterclockwise from outside, by the bits of its corners. */
  private static final int[][] FACES = {
    {1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}
  };

  @BeforeEach
  void writeHollowBox() throws IOException {
    StringBuilder text = new StringBuilder("o box\n");
    for (int i = 0; i < 16; i++) {
      int low = i < 8 ? 0 : 1;
      int high = i < 8 ? 10 : 9;
      text.append(
          "v %d %d %d\n"
              .formatted(
                  (i & 1) == 0 ? low : high, (i & 2) == 0 ? low : high, (i & 4) == 0 ? low : high));
    }
    for (int[] f : FACES) {
      text.append("f %d %d %d %d\n".formatted(f[0], f[1], f[2], f[3]));
      text.append("f %d %d %d %d\n".formatted(f[3] + 8, f[2] + 8, f[1] + 8, f[0] + 8));
    }
    Files.writeString(directory.resolve("box.obj"), text.toString());
  }

  @Test
  void theImportedSceneAndTheFilmHaveTheSamePicture() throws IOException {
    String flags = " --section x=50% --section 0,0,-3/0,-1,-1 --up z --unit 3";
    runs("import T/box.obj -o T/scene.json" + flags);
    assertThat(Files.readString(directory.resolve("scene.json")))
        .containsIgnoringWhitespaces("\"section\": [\"x=50%\", \"0,0,-3/0,-1,-1\"]");
    runs("render T/scene.json -o T/a.pfm" + SMALL);
    runs("render T/box.obj -o T/b.pfm" + SMALL + flags);
    assertThat(directory.resolve("a.pfm")).hasSameBinaryContentAs(directory.resolve("b.pfm"));
    runs(
        "render T/box.obj -o T/c.pfm --checkpoint T/c.film -s 1"
            + SMALL.replace(" -s 2", "")
            + flags);
    runs("resume T/c.film -s 2 -o T/d.pfm --quiet");
    assertThat(directory.resolve("d.pfm")).hasSameBinaryContentAs(directory.resolve("b.pfm"));
  }

  /** The far wall of the cavity is lit by the sky alone, which it sees through the opening. */
  @Test
  void lightEntersTheCut() throws IOException {
    runs(
        "render T/box.obj -o T/a.png --view front --sky white --section z=9"
            + SMALL.replace(" -s 2", " -s 64"));
    BufferedImage picture = ImageIO.read(directory.resolve("a.png").toFile());
    int wall = picture.getRGB(12, 9) & 0xff;
    assertThat(wall).isBetween(100, 250);
  }

  @Test
  void cutPicturesAreFramedAsWholeOnes() throws IOException {
    runs("check T/box.obj");
    String whole = run("check T/box.obj").out();
    String cut = run("check T/box.obj --section y=50%").out();
    assertThat(whole).contains("bounds     (0, 0, 0) to (10, 10, 10)");
    assertThat(cut).contains("bounds     (0, 0, 0) to (10, 10, 10)");
  }

  @Test
  void sectionsThatCannotBeUsedAreReported() {
    Outcome wrong = run("render T/box.obj -o T/a.png --section x:5");
    assertThat(wrong.exitCode()).isEqualTo(2);
    assertThat(wrong.err())
        .contains("--section: expected a plane such as x=0.5, y=50%, -z=2 or a point");
    Outcome nothing = run("render T/box.obj -o T/a.png --section x=-1");
    assertThat(nothing.exitCode()).isEqualTo(4);
    assertThat(nothing.err())
        .contains("box.obj: --section: expected a plane that leaves something of the model, which")
        .contains("from x=0 to 10, y=0 to 10, z=0 to 10 in the unit of the file, found x=-1");
    Outcome outside = run("check T/box.obj --section x=11").done();
    assertThat(outside.err()).contains("section x=11 cuts nothing of the model, which is from x=0");
  }

  @Test
  void viewsAreCut() throws IOException {
    runs("views T/box.obj -o T/v --section -x=5 -s 1 --no-denoise --size 24x18");
    runs(
        "render T/box.obj -o T/left.png --view left --section -x=5 -s 1 --no-denoise --size 24x18");
    assertThat(pixels("v/left.png")).containsExactly(pixels("left.png"));
  }
}
