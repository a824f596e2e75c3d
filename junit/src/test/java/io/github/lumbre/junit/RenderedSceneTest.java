package io.github.lumbre.junit;

import static io.github.lumbre.junit.GoldenPictures.assertThatPicture;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Image;
import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ParameterResolutionException;

/** Tests pictures that the extension passes to tests. */
class RenderedSceneTest {
  /** PartTest is the example of the page, and passes. */
  @Test
  void exampleOfThePageIsATest() throws IOException {
    assertThat(Files.readString(Path.of("../docs/golden.md")))
        .contains("```java\n" + Files.readString(Path.of("src/test/java/PartTest.java")) + "```");
  }

  @Test
  @RenderedScene(
      value = "part.obj",
      view = "-40,15",
      up = "z",
      width = 64,
      height = 48,
      samples = 64)
  void annotationOfTheMethod(Image picture) {
    assertThatPicture(picture).matches("part-from-the-left");
  }

  @Test
  @RenderedScene(value = "part.obj", width = 64, height = 48, samples = 4, denoise = true)
  void denoised(Image picture) {
    assertThatPicture(picture).withTolerance(0).matches("part-denoised");
  }

  /** Four samples, denoised, are nearer to the picture of many samples than four that are not. */
  @Test
  void denoisedPicturesHaveLessNoise(
      @RenderedScene(value = "part.obj", width = 64, height = 48, samples = 256) Image clean,
      @RenderedScene(value = "part.obj", width = 64, height = 48, samples = 4) Image noisy,
      @RenderedScene(value = "part.obj", width = 64, height = 48, samples = 4, denoise = true)
          Image denoised) {
    assertThat(squares(denoised, clean)).isLessThan(squares(noisy, clean) / 2);
  }

  private static double squares(Image picture, Image clean) {
    double sum = 0;
    for (int y = 0; y < clean.height(); y++) {
      for (int x = 0; x < clean.width(); x++) {
        double difference = picture.pixel(x, y).luminance() - clean.pixel(x, y).luminance();
        sum += difference * difference;
      }
    }
    return sum;
  }

  @Test
  void twoPictures(
      @RenderedScene(value = "../scenes/cornell-box.json", width = 32, height = 24, samples = 1)
          Image scene,
      @RenderedScene(value = "part.obj", width = 16, height = 16, samples = 1) Image model) {
    assertThat(scene.width()).isEqualTo(32);
    assertThat(model.width()).isEqualTo(16);
  }

  void missing(@RenderedScene("none.obj") Image picture) {}

  void viewOfScene(
      @RenderedScene(value = "../scenes/cornell-box.json", view = "top") Image picture) {}

  void wrongView(@RenderedScene(value = "part.obj", view = "topp") Image picture) {}

  void wrongSize(@RenderedScene(value = "part.obj", width = -1) Image picture) {}

  @Test
  void errorsNameTheScene() throws NoSuchMethodException {
    assertFails("missing", "@RenderedScene(\"none.obj\"): none.obj: ");
    assertFails("viewOfScene", "expected a model, found a scene");
    assertFails("wrongView", "expected front, back, left, right, top, bottom, iso or AZIMUTH");
    assertFails("wrongSize", "width");
  }

  private static void assertFails(String name, String message) throws NoSuchMethodException {
    Method method = RenderedSceneTest.class.getDeclaredMethod(name, Image.class);
    RenderedScene wanted = method.getParameters()[0].getAnnotation(RenderedScene.class);
    assertThatThrownBy(() -> RenderedSceneExtension.picture(wanted))
        .isInstanceOf(ParameterResolutionException.class)
        .hasMessageContaining(message);
  }
}
