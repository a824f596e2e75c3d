package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import java.io.IOException;
import org.junit.jupiter.api.Test;

/** Layers of denoised pictures, and pictures whose layers are other than a denoiser's own. */
class DenoisedLayersTest extends CommandFixture {
  private static Outcome run(String... line) {
    return Outcome.of(line).done();
  }

  private float[] light(String name) throws IOException {
    return LayeredImage.read(directory.resolve(name)).layers().stream()
        .filter(layer -> layer.name().isEmpty())
        .findFirst()
        .orElseThrow()
        .values();
  }

  /** The layers of a denoised picture are those of the samples. */
  @Test
  void lightGroupsAddUpToTheNoisyPicture() throws IOException {
    String sun =
        "{\"type\": \"Light\", \"lightType\": \"Directional\", \"intensity\": 1,"
            + " \"lightGroup\": \"sun\", \"localRotation\": {\"x\": 60, \"y\": 0, \"z\": 0}}, ";
    String scene =
        TinyScene.write(directory, TinyScene.with("{\"id\": 5", sun + "{\"id\": 5")).toString();
    run("render", scene, "-s", "8", "-o", path("noisy.exr"), "--layers", "lights");
    run("render", scene, "-s", "8", "-o", path("x.exr"), "--layers", "lights", "--denoise");
    float[] noisy = light("noisy.exr");
    assertThat(light("x.exr")).isNotEqualTo(noisy);
    float[] sum = new float[noisy.length];
    int groups = 0;
    for (ImageLayer layer : LayeredImage.read(directory.resolve("x.exr")).layers()) {
      if (layer.name().startsWith("lights.")) {
        groups++;
        for (int i = 0; i < sum.length; i++) {
          sum[i] += layer.values()[i];
        }
      }
    }
    assertThat(groups).isEqualTo(2);
    for (int i = 0; i < sum.length; i++) {
      assertThat(sum[i]).isCloseTo(noisy[i], within(.002f * (1 + noisy[i])));
    }
  }

  /** The layers albedo and normal, which other programs write, help as much as they can. */
  @Test
  void layersOfOtherProgramsAreGuides() throws IOException {
    String scene = TinyScene.write(directory, TinyScene.JSON).toString();
    run("render", scene, "-s", "8", "-o", path("x.exr"), "--layers", "albedo,normal,variance");
    Outcome guided = run("denoise", path("x.exr"), "-o", path("clean.exr"));
    assertThat(guided.err()).contains("denoised: ").doesNotContain("lacks");
    run("render", scene, "-s", "8", "-o", path("y.exr"), "--layers", "variance");
    Outcome bare = run("denoise", path("y.exr"), "-o", path("less.exr"));
    assertThat(bare.err()).contains("lacks the layer denoisingAlbedo");
    assertThat(light("clean.exr")).isNotEqualTo(light("less.exr"));
  }
}
