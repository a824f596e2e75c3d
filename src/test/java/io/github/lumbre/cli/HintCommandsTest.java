package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Commands print one hint where a flag helps for certain, and none elsewhere. */
class HintCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 2 -o T/a.png";
  private static final String UPRIGHT = "hint: the model stands on the plane z = 0";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  private List<String> hints(String line) {
    return said(line).lines().filter(text -> text.contains("hint: ")).toList();
  }

  /** Writes a pyramid with a rectangle as its base, in the plane of the lowest z. */
  private void writePyramid(String name, double[] low, double[] high) throws IOException {
    double[][] corners = {
      {low[0], low[1], low[2]},
      {high[0], low[1], low[2]},
      {high[0], high[1], low[2]},
      {low[0], high[1], low[2]},
      {.5 * (low[0] + high[0]), .5 * (low[1] + high[1]), high[2]}
    };
    int[][] faces = {{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    boolean isStl = name.endsWith("stl") || name.endsWith("STL");
    StringBuilder text = new StringBuilder(isStl ? "solid a\n" : "");
    int count = 0;
    for (int[] face : faces) {
      StringBuilder loop = new StringBuilder();
      for (int corner : face) {
        double[] at = corners[corner];
        loop.append(isStl ? "vertex" : "v")
            .append(String.format(Locale.ROOT, " %f %f %f%n", at[0], at[1], at[2]));
      }
      String of = "f %d %d %d%n".formatted(count + 1, count + 2, count + 3);
      text.append(isStl ? "facet normal 0 0 0\nouter loop\n" : "");
      text.append(loop).append(isStl ? "endloop\nendfacet\n" : of);
      count += 3;
    }
    Files.writeString(directory.resolve(name), text + (isStl ? "endsolid a\n" : ""));
  }

  /** A tower on z = 0 lies on its side if +Y is up; other models may be right as they are. */
  @ParameterizedTest
  @CsvSource({
    "tower.stl, -1, -1, 0, 1, 1, 3, true",
    "TOWER.STL, -1, -1, 0, 1, 1, 3, true",
    "tower.obj, -1, -1, 0, 1, 1, 3, false",
    "relief.stl, -3, -2, 0, 3, 2, 1, false",
    "hanging.stl, -1, -1, -3, 1, 1, 0, false",
    "middle.stl, -1, -1, -1.5, 1, 1, 1.5, false",
    "corner.stl, 0, 0, 0, 1, 1, 3, false",
    "tall.stl, -1, -3, 0, 1, 3, 2, false"
  })
  void towersOnTheirSideAreStoodUpright(
      String name, double x, double y, double z, double right, double back, double up, boolean is)
      throws IOException {
    writePyramid(name, new double[] {x, y, z}, new double[] {right, back, up});
    String line = "render T/" + name + SMALL;
    assertThat(hints(line)).hasSize(is ? 1 : 0).allMatch(hint -> hint.startsWith(UPRIGHT));
    assertThat(hints(line + " --up z")).isEmpty();
    assertThat(hints(line + " --up y")).isEmpty();
    assertThat(hints(line + " --quiet")).isEmpty();
    assertThat(hints(line + " --json")).isEmpty();
  }

  @Test
  void modelsOutOfViewOfTheirCameraAreFramed() throws IOException {
    ModelSample.writeWith(
        directory, "\"translation\": [5, 1.3, 4]", "\"translation\": [5, 1.3, -40]");
    assertThat(hints("render T/sample.glb" + SMALL))
        .containsExactly(
            "hint: nothing is in view: no camera ray hits an object; --view iso shows the whole"
                + " model");
    assertThat(hints("render T/sample.glb --view iso" + SMALL)).isEmpty();
    assertThat(hints("render T/sample.glb --json" + SMALL)).isEmpty();
  }

  /** An exposure cannot brighten what has no light. */
  @Test
  void unlitPicturesSayThatTheyHaveNoLight() throws IOException {
    assertThat(hints("render T/sample.glb --sky-intensity 0 --background black" + SMALL))
        .containsExactly(
            "hint: the picture is black, because the scene has no light; without --sky and"
                + " --sky-intensity, a studio lights it");
    Files.writeString(
        directory.resolve("dark.json"), TinyScene.with("\"intensity\": 3", "\"intensity\": 0"));
    assertThat(hints("render T/dark.json" + SMALL))
        .containsExactly(
            "hint: the picture is black, because the scene has no light; add one, such as a Dome");
    assertThat(hints("render T/dark.json -o T/a.exr --size 24x18 -s 2")).isEmpty();
  }

  @Test
  void noisyPicturesNeedMoreSamples() {
    String noisy = "render scenes/models/lantern.glb --view 0,89 -o T/a.png --size 128x128 -s 2";
    assertThat(hints(noisy))
        .hasSize(1)
        .allMatch(hint -> hint.matches("hint: the denoised picture has an error of .*; -s 200 .*"));
    assertThat(hints(noisy + " --no-denoise")).isEmpty();
    assertThat(hints(noisy + " --json")).isEmpty();
  }

  @Test
  void commandsPrintOneHint() throws IOException {
    writePyramid("tower.stl", new double[] {-1, -1, 0}, new double[] {1, 1, 3});
    assertThat(hints("render T/tower.stl --sky-intensity 0" + SMALL))
        .hasSize(1)
        .allMatch(hint -> hint.contains("the picture is black"));
    String two = "render T/tower.stl T/sample.glb --sky-intensity 0 --size 24x18 -s 2 -o T/out";
    assertThat(hints(two)).hasSize(1);
    assertThat(hints("render T/sample.glb" + SMALL)).isEmpty();
  }
}
