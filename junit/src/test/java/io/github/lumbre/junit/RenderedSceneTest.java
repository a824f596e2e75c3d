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
