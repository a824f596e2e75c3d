package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the tile cache of computed texels. */
class TexelsTest {
  @ParameterizedTest
  @CsvSource({"1, 1", "32, 32", "33, 31", "100, 70", "1, 999"})
  void smallTexturesAreComputedOnce(int width, int height) {
    AtomicInteger computed = new AtomicInteger();
    Texels texels =
        new Texels(width, height, (x, y) -> computed.incrementAndGet() * 0.0 + x + 1000 * y);
    for (int pass = 0; pass < 2; pass++) {
      for (int i = 0; i < width * height; i++) {
        assertThat(texels.at(i % width, i / width)).isEqualTo(i % width + 1000 * (i / width));
      }
    }
    assertThat(computed).hasValue(width * height);
  }

  @ParameterizedTest
  @CsvSource({"16384, 16384", "2049, 2048"})
  void largeTexturesAreComputedEachTime(int width, int height) {
    AtomicInteger computed = new AtomicInteger();
    Texels texels =
        new Texels(width, height, (x, y) -> computed.incrementAndGet() * 0.0 + x + 1e6 * y);
    assertThat(texels.at(width - 1, height - 1)).isEqualTo(width - 1 + 1e6 * (height - 1));
    assertThat(texels.at(width - 1, height - 1)).isEqualTo(width - 1 + 1e6 * (height - 1));
    assertThat(computed).hasValue(2);
  }

  @ParameterizedTest
  @CsvSource({"2048, 2048", "16384, 256"})
  void onlyTheTileThatIsAskedForIsComputed(int width, int height) {
    AtomicInteger computed = new AtomicInteger();
    Texels texels = new Texels(width, height, (x, y) -> computed.incrementAndGet());
    texels.at(width - 1, height - 1);
    texels.at(width - 2, height - 1);
    assertThat(computed).hasValue(32 * 32);
  }

  @ParameterizedTest
  @CsvSource({"0, 5", "5, 0", "16385, 1", "1, 16385"})
  void sizesOutsideTheRangeAreRefused(int width, int height) {
    assertThatThrownBy(() -> new Texels(width, height, (x, y) -> 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("width and height: expected 1 to 16384, found " + width + "x" + height);
  }
}
