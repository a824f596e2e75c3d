package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import org.junit.jupiter.api.Test;

/** Tests {@code lumbre check}. */
class CheckCommandTest extends CommandFixture {
  private Outcome check(String json, String... flags) {
    return withScene(json, "check T/tiny.json", flags);
  }

  @Test
  void contentsOfAValidSceneAreTold() {
    Outcome outcome = check(TinyScene.JSON).done();
    assertThat(outcome.err()).isEmpty();
    assertThat(outcome.out().lines())
        .contains(
            "camera     Pinhole",
            "size       16x12 pixels",
            "mode       path, depth 5",
            "samples    2 per pixel",
            "shapes     3",
            "triangles  0",
            "lights     1",
            "materials  2",
            "textures   0",
            "warnings   0");
  }

  /** A PNG of a model is denoised by default, and then has fewer samples than its scene. */
  @Test
  void samplesOfAModelAreThoseOfItsDefaultPicture() throws IOException {
    ModelSample.write(directory);
    String model = directory.resolve("sample.glb").toString();
    assertThat(Outcome.of("check", model).out().lines())
        .contains("samples    8 per pixel, denoised");
    assertThat(Outcome.of("check", model, "--json").out()).contains("\"samples_per_pixel\":8,");
  }

  @Test
  void workThatTheSceneDoesNotRequireIsTold() {
    assertThat(check(TinyScene.JSON).out()).doesNotContain("plan");
    assertThat(check(TinyScene.JSON, "--plan").out().lines().skip(12))
        .containsExactly(
            "plan       assets: all are used",
            "           materials: 3 of 3 surfaces have a uniform BSDF, computed once instead of at"
                + " every hit",
            "           normals: skipped, there are no normal maps",
            "           meshes: skipped, there are none",
            "           light selection: skipped, there is a single light",
            "           path guiding: skipped, it is off",
            "           lens: skipped, the camera has no lens",
            "           pixel coverage: skipped, every sample covers its pixel");
  }

  @Test
  void assetsThatNothingUsesAreNotDecoded() {
    String scene =
        TinyScene.withAsset(
            "{\"id\": 8, \"assetType\": \"Mesh\", \"file\": \"none.obj\"},"
                + " {\"id\": 9, \"assetType\": \"Texture\", \"file\": \"none.png\"}");
    assertThat(check(scene, "--plan").out())
        .contains("assets: not decoded, because unused: mesh 1, texture 1");
  }

  @Test
  void allThatIsWrongIsToldInOneRun() {
    String wrong =
        TinyScene.with("\"radius\": 1", "\"radius\": -1")
            .replace("\"intensity\": 3", "\"intensity\": -3");
    Outcome outcome = check(wrong);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.SCENE);
    assertThat(outcome.out()).isEmpty();
    assertThat(outcome.err().lines())
        .hasSize(2)
        .anyMatch(line -> line.startsWith("tiny.json: $.objects[2].radius: expected"))
        .anyMatch(line -> line.startsWith("tiny.json: $.objects[4].intensity: expected"));
  }

  @Test
  void warningsFailOnlyUnderStrictness() {
    String odd = TinyScene.with("\"radius\": 1", "\"radius\": 1, \"colour\": 2");
    Outcome relaxed = check(odd).done();
    assertThat(relaxed.err()).startsWith("warning: ");
    assertThat(relaxed.out()).contains("warnings   1");
    assertThat(check(odd, "--strict").exitCode()).isEqualTo(ExitCodes.WARNINGS);
  }
}
