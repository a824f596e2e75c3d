package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.scene.internal.FrameSize;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests sizes of frames as users state them. */
class FrameSizeTest {
  /** One number is the longer side; the other keeps the aspect ratio, and is at least a pixel. */
  @ParameterizedTest
  @CsvSource({
    "800, 1024, 768, 800, 600",
    "800, 768, 1024, 600, 800",
    "800, 100, 100, 800, 800",
    "3840, 1920, 1080, 3840, 2160",
    "101, 1920, 1080, 101, 57",
    "1, 1920, 1080, 1, 1",
    "9, 65535, 1, 9, 1",
    "65535, 2, 1, 65535, 32768",
    "640x480, 1920, 1080, 640, 480",
    "5x700, 1920, 1080, 5, 700"
  })
  void aSideKeepsTheAspectRatio(String text, int width, int height, int newWidth, int newHeight) {
    RenderSettings before = RenderSettings.builder().size(width, height).samples(7).build();
    RenderSettings after = FrameSize.of(text).over(before);
    assertThat(after)
        .isEqualTo(RenderSettings.builder().size(newWidth, newHeight).samples(7).build());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x", "800x", "x600", "8 x 6", "-800", "8e2", "800.0", "1234567890"})
  void otherTextsAreRefused(String text) {
    assertThatThrownBy(() -> FrameSize.of(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "expected WxH, such as 640x480, or the longer side, such as 640, found '"
                + text
                + "'");
  }

  @Test
  void sidesOutOfRangeAreRefused() {
    RenderSettings settings = RenderSettings.DEFAULT;
    for (String text : new String[] {"0", "65536", "0x5", "5x70000"}) {
      assertThatThrownBy(() -> FrameSize.of(text).over(settings))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("expected 1 to 65535");
    }
  }
}
