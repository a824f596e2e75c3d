package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Commands show clouds of points. */
class PointsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 2 --seed 3 --quiet --no-denoise";

  @BeforeEach
  void writeCloud() throws IOException {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 64; i++) {
      text.append("v %d %d %d %f 0 1\n".formatted(i % 4, i / 4 % 4, i / 16, i / 64.));
    }
    Files.writeString(directory.resolve("cloud.obj"), text.append("p 1 2\np 3\n"));
    Files.writeString(directory.resolve("all.obj"), text.toString().replace("p 1 2\np 3\n", ""));
  }

  @Test
  void checkCountsPoints() {
    assertThat(run("check T/cloud.obj").out())
        .contains("shapes     1\nmeshes     0\ntriangles  0\npoints     3\nlights")
        .contains("bounds     (-0.5, -0.5, -0.5) to (2.5, 0.5, 0.5), size 3 x 1 x 1\n");
    assertThat(run("check T/cloud.obj --json").out()).contains("\"triangles\":0,\"points\":3,");
    assertThat(run("check T/all.obj --points 2 --unit 10").out())
        .contains("points     64")
        .contains("(-20, -20, -20) to (50, 50, 50)");
  }

  @Test
  void theImportedSceneHasTheSamePicture() throws IOException {
    for (String flags : new String[] {"", " --points 0.25 --up z --unit 3"}) {
      runs("import T/all.obj -o T/scene.json --overwrite" + flags);
      runs("render T/scene.json -o T/a.pfm --overwrite" + SMALL);
      runs("render T/all.obj -o T/b.pfm --overwrite" + SMALL + flags);
      assertThat(directory.resolve("a.pfm")).hasSameBinaryContentAs(directory.resolve("b.pfm"));
    }
    assertThat(Files.readString(directory.resolve("scene.json"))).contains("\"pointRadius\"");
  }

  /** The spheres, not only their centers, are in the frame. */
  @Test
  void theFrameContainsTheSpheres() throws IOException {
    for (String view : new String[] {"front", "iso", "30,20"}) {
      runs(
          "render T/cloud.obj -o T/a.png --overwrite --background transparent --points 3 --view "
              + view
              + SMALL.replace("24x18", "60x45"));
      BufferedImage picture = picture("a.png");
      int covered = 0;
      for (int y = 0; y < 45; y++) {
        for (int x = 0; x < 60; x++) {
          int alpha = picture.getRGB(x, y) >>> 24;
          boolean isBorder = x == 0 || y == 0 || x == 59 || y == 44;
          assertThat(isBorder ? alpha : 0).as(view).isZero();
          covered += alpha > 0 ? 1 : 0;
        }
      }
      assertThat(covered).as(view).isGreaterThan(600);
    }
  }
}
