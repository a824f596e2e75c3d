package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Tests how the file extension selects the picture format. */
class ImageFormatTest {
  @Test
  void theEndingDecidesInAnyCase() {
    assertThat(ImageFormat.of(Path.of("a.png"))).contains(ImageFormat.PNG);
    assertThat(ImageFormat.of(Path.of("dir.exr", "A.PnG"))).contains(ImageFormat.PNG);
    assertThat(ImageFormat.of(Path.of("a.b.PFM"))).contains(ImageFormat.PFM);
    assertThat(ImageFormat.of(Path.of("a.exr"))).contains(ImageFormat.EXR);
    assertThat(ImageFormat.of(Path.of("a.jpg"))).contains(ImageFormat.JPG);
    assertThat(ImageFormat.of(Path.of("a.JPEG"))).contains(ImageFormat.JPG);
  }

  @Test
  void otherEndingsNameNone() {
    assertThat(ImageFormat.of(Path.of("png"))).isEmpty();
    assertThat(ImageFormat.of(Path.of("a.png.bak"))).isEmpty();
    assertThat(ImageFormat.of(Path.of("a.gif"))).isEmpty();
    assertThat(ImageFormat.of(Path.of("/"))).isEmpty();
  }

  @Test
  void endingsAreListed() {
    assertThat(ImageFormat.endings()).isEqualTo(".png, .pfm, .exr, .jpg, .jpeg");
  }
}
