package io.github.lumbre.render.stopping;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.lab.checks.Coverage;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.testing.Effort;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Bounds hold with the stated confidence: renders with independent seeds are compared with a
 * reference of 64 times as many samples.
 *
 * <p>With 200 seeds and a true coverage of 95 %, 25 or more failures have a probability of 2e-5. A
 * coverage of 80 % is detected with a probability of 0.998. The quick form with 12 seeds finds
 * gross errors only: with a coverage of 30 %, it passes with a probability of 2e-3.
 */
class NoiseCoverageTest {
  private static final int SIDE = 16;

  @TempDir private Path directory;

  @ParameterizedTest
  @CsvSource({
    "cornell-box, .1, false",
    "cornell-box-dome, .1, false",
    "cornell-box-sphere-light, .1, false",
    "glass-and-mirror, .2, false",
    "camera-thin-lens, .1, false",
    "table-11-marble, .1, false",
    "cornell-box, .1, true",
    "glass-and-mirror, .15, true",
    "camera-thin-lens, .1, true"
  })
  void errorsAreAtMostWhatIsClaimed(String name, double target, boolean adaptive) throws Exception {
    int seeds = Effort.count(12, 200);
    Coverage.Cell cell =
        coverage(scene(name), SIDE, adaptive, seeds, Effort.count(2048, 32768))
            .ofTarget(target, 1 << 14);
    assertThat(cell.reached()).isEqualTo(seeds);
    assertHolds(cell, Effort.count(8, 25));
  }

  /**
   * Bounds from 4, 8 and 16 samples hold. The scenes include a room lit mostly by rare bright
   * paths, and one where glass encloses one of two lights. With 100 seeds and a true coverage of 95
   * %, 14 or more failures have a probability of 4e-4. A coverage of 75 % is detected with a
   * probability of 0.998. The quick form detects a coverage of 30 % with a probability of 0.998.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "cornell-box",
        "glass-and-mirror",
        "camera-thin-lens",
        "table-11-marble",
        "torus-knot",
        "table-07-suited-figure",
        "light in glass"
      })
  void boundsOfFewSamplesHold(String name) throws Exception {
    SceneFile file = name.equals("light in glass") ? lightInGlass() : scene(name);
    Coverage coverage =
        coverage(file, SIDE, false, Effort.count(12, 100), Effort.count(1024, 4096));
    for (Coverage.Cell cell : coverage.ofSamples(List.of(4, 8, 16))) {
      assertHolds(cell, Effort.count(8, 14));
    }
  }

  /**
   * Bounds hold where few bright samples carry the noise. Compared with their own halves alone, 12
   * to 19 of 60 pictures of the rough metal exceed their bounds.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "lamp-on-rough-metal",
        "lamp-in-a-rough-mirror",
        "sun-through-a-slit",
        "emissive-points"
      })
  void boundsHoldWhereFewBrightSamplesCarryTheNoise(String name) throws Exception {
    Path path = Path.of("src", "test", "resources", "io", "github", "lumbre", "render", "stopping");
    SceneFile file = new SceneParser().parse(path.resolve(name + ".json"));
    Coverage coverage =
        coverage(file, 24, false, Effort.count(12, 60), Effort.count(2048, 16384));
    for (Coverage.Cell cell : coverage.ofSamples(List.of(16, 32, 64))) {
      assertHolds(cell, Effort.count(5, 10));
    }
  }

  /** Bounds from 32 and 64 samples hold where rare bright paths light every pixel. */
  @Test
  void boundsHoldWhereRareBrightPathsLightEveryPixel() throws Exception {
    Coverage coverage =
        coverage(scene("table-11-marble"), 24, false, Effort.count(12, 100), 4096);
    for (Coverage.Cell cell : coverage.ofSamples(List.of(32, 64))) {
      assertHolds(cell, Effort.count(3, 14));
    }
  }

  private static void assertHolds(Coverage.Cell cell, int fewestFailures) {
    if (Effort.isExhaustive()) {
      System.out.println(cell.line());
    }
    assertThat(cell.beyond()).as(cell.line()).isLessThan(fewestFailures);
  }

  private static Coverage coverage(
      SceneFile file, int side, boolean adaptive, int seeds, int referenceSamples) {
    RenderSettings settings =
        file.settings().toBuilder().size(side, side).adaptive(adaptive).build();
    return new Coverage(file.scene(), settings, seeds, referenceSamples);
  }

  private static SceneFile scene(String name) throws Exception {
    return new SceneParser().parse(Path.of("scenes", name + ".json"));
  }

  /**
   * Returns a room with two lights. One is small and inside a glass sphere, which causes caustics.
   */
  private SceneFile lightInGlass() throws Exception {
    String scene = Files.readString(Path.of("scenes", "cornell-box-sphere-light.json"));
    String glass =
        "{\"id\": 50, \"assetType\": \"Material\", \"materialType\": \"Refractive\", \"ior\": 1.5}";
    String place = "\"localPosition\": {\"x\": 1.2, \"y\": 1.2, \"z\": 1.2}}";
    String light =
        "{\"id\": 60, \"type\": \"Light\", \"lightType\": \"Sphere\", \"unit\": \"radiance\","
            + " \"intensity\": 800, \"radius\": 0.08, "
            + place;
    String ball =
        "{\"id\": 61, \"type\": \"Shape\", \"shapeType\": \"Sphere\", \"materialID\": 50,"
            + " \"radius\": 0.4, "
            + place;
    String changed =
        scene
            .replaceFirst("\"assets\": \\[", "\"assets\": [" + glass + ",")
            .replaceFirst("\"objects\": \\[", "\"objects\": [" + light + "," + ball + ",");
    assertThat(changed).contains(glass, ball);
    return new SceneParser()
        .parse(Files.writeString(directory.resolve("light-in-glass.json"), changed));
  }
}
