import static io.github.lumbre.junit.GoldenPictures.assertThatPicture;

import io.github.lumbre.image.Image;
import io.github.lumbre.junit.RenderedScene;
import org.junit.jupiter.api.Test;

class PartTest {
  @Test
  void part(
      @RenderedScene(
              value = "part.obj",
              view = "iso",
              ground = true,
              width = 64,
              height = 48,
              samples = 64)
          Image picture) {
    assertThatPicture(picture).matches("part-iso");
  }
}
