package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import org.junit.jupiter.api.Test;

class DecodedPicturesTest {
  private final DecodedPictures pictures = new DecodedPictures();

  private static byte[] png(int gray) {
    return Pixels.of(1, 1, 3, new byte[] {(byte) gray, (byte) gray, (byte) gray}).toPng();
  }

  @Test
  void equalFilesAreDecodedOnce() throws ImageFormatException {
    Pixels first = pictures.of(png(7), Limits.NONE);

    assertThat(pictures.of(png(7), Limits.NONE)).isSameAs(first);
    assertThat(pictures.of(png(8), Limits.NONE).raw(0, 0, 0)).isEqualTo(8);
  }

  @Test
  void aKnownPictureKeepsToTheLimits() throws ImageFormatException {
    pictures.of(png(7), Limits.NONE);

    assertThatThrownBy(() -> pictures.of(png(7), Limits.NONE.withTexels(0)))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageContaining("1x1 pixels, expected at most 0");
  }

  @Test
  void aPictureThatCannotBeDecodedFailsEachTime() {
    for (int i = 0; i < 2; i++) {
      assertThatThrownBy(() -> pictures.of(new byte[] {1, 2, 3}, Limits.NONE))
          .isInstanceOf(ImageFormatException.class);
    }
  }
}
