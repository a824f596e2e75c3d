package io.github.lumbre.stage.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Names below pictures are inside their line, whatever they are. */
class CaptionTest {
  private static final int WIDTH = 120;

  /** Returns the darkness of each column. */
  private static double[] columns(String text) {
    Image image = Caption.of(text, WIDTH, false);
    double[] columns = new double[WIDTH];
    for (int y = 0; y < image.height(); y++) {
      for (int x = 0; x < WIDTH; x++) {
        columns[x] += 1 - image.pixel(x, y).g();
      }
    }
    return columns;
  }

  private static double sum(String text) {
    double sum = 0;
    for (double column : columns(text)) {
      sum += column;
    }
    return sum;
  }

  @Test
  void textsAreInTheMiddle() {
    double[] columns = columns("HOH");
    for (int x = 0; x < WIDTH / 2; x++) {
      assertThat(columns[x])
          .as("column " + x)
          .isCloseTo(columns[WIDTH - 1 - x], within(.2));
    }
    assertThat(columns[2]).isZero();
    assertThat(sum("HOH")).isGreaterThan(30);
  }

  /** Nothing touches the edges, and a line of any text has the same height. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "part.glb",
        "a\u0000b\u001b[31mred\nline\ttab\r",
        "\"quotes\" 'single' `back` \\ /",
        "\ud800 half of a character",
        "\u202eright to left\u202c",
        "\u4e2d\u6587.glb",
        "\ud83d\ude80.glb",
        "%s %d {} <script>",
        "________________________________________________",
        "\u00c4\u00c4gj,;|"
      })
  void anyTextIsDrawnInsideItsLine(String text) {
    for (int width : new int[] {1, 7, 64, WIDTH, 700}) {
      Image image = Caption.of(text, width, false);
      assertThat(image.width()).isEqualTo(width);
      assertThat(image.height()).isEqualTo(Caption.height(width));
      for (int x = 0; x < width; x++) {
        assertThat(image.pixel(x, 0).g()).isEqualTo(1);
        assertThat(image.pixel(x, image.height() - 1).g()).isEqualTo(1);
      }
      for (int y = 0; y < image.height(); y++) {
        assertThat(image.pixel(0, y).g()).isEqualTo(1);
        assertThat(image.pixel(width - 1, y).g()).isEqualTo(1);
      }
    }
    assertThat(sum(text)).isPositive();
  }

  /** The end of a name often tells it from others. */
  @Test
  void longTextsLackTheirMiddle() {
    String start = "controller_with_a_long_name_";
    assertThat(columns(start + "1.glb")).isNotEqualTo(columns(start + "2.glb"));
    assertThat(columns("1" + start + ".glb")).isNotEqualTo(columns("2" + start + ".glb"));
    assertThat(columns(start + "1" + start)).isEqualTo(columns(start + "2" + start));
    String huge = "x".repeat(5000) + "y" + "x".repeat(5000);
    assertThat(columns(huge)).isEqualTo(columns("x".repeat(300)));
    assertThat(sum(huge)).isPositive();
  }

  /** An accent in a character of its own, as in names of files on macOS, is no box. */
  @Test
  void accentsAreComposed() {
    assertThat(columns("Mu\u0308nze")).isEqualTo(columns("M\u00fcnze"));
  }

  @Test
  void textsHaveAnEdgeOnATransparentGround() {
    Image image = Caption.of("part.glb", WIDTH, true);
    int black = 0;
    int white = 0;
    int clear = 0;
    for (int i = 0; i < WIDTH * image.height(); i++) {
      int x = i % WIDTH;
      int y = i / WIDTH;
      clear += image.alpha(x, y) == 0 ? 1 : 0;
      white += image.alpha(x, y) > .9 && image.pixel(x, y).g() > .9 ? 1 : 0;
      black += image.alpha(x, y) > .9 && image.pixel(x, y).g() < .5 ? 1 : 0;
    }
    assertThat(black).isGreaterThan(30);
    assertThat(white).isGreaterThan(30);
    assertThat(clear).isGreaterThan(WIDTH * image.height() / 3);
  }

  @Test
  void namesHaveRoomIfSomeOfThemCanBeRead() {
    assertThat(Caption.hasRoom("part.glb", 64)).isTrue();
    assertThat(Caption.hasRoom("a.off", 64)).isTrue();
    assertThat(Caption.hasRoom("x".repeat(10_000), 64)).isTrue();
    assertThat(Caption.hasRoom("part.glb", 20)).isFalse();
    assertThat(Caption.hasRoom("part.glb", 1)).isFalse();
  }
}
