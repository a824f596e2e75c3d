package io.github.lumbre.stage.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the shapes of characters, and where text is. */
class StrokeFontTest {
  private static final String SIGNS = "°±×²³µøØ⌀−äöüÄÖÜß";

  private static String shape(Glyph glyph) {
    return glyph.strokes().stream().map(Arrays::toString).collect(Collectors.joining(";"));
  }

  @Test
  void allCharactersHaveShapes() {
    String ascii =
        IntStream.range(' ', 127).mapToObj(Character::toString).collect(Collectors.joining());
    assertThat(GlyphTable.characters())
        .containsExactlyElementsOf(
            (ascii + SIGNS).codePoints().sorted().boxed().collect(Collectors.toList()));
  }

  @Test
  void shapesLieInTheirCells() {
    for (int character : GlyphTable.characters()) {
      Glyph glyph = GlyphTable.of(character);
      double right = 0;
      for (double[] points : glyph.strokes()) {
        assertThat(points.length).as("%c", character).isGreaterThanOrEqualTo(4);
        for (int i = 0; i < points.length; i += 2) {
          assertThat(points[i]).as("%c", character).isBetween(0., glyph.width());
          assertThat(points[i + 1])
              .as("%c", character)
              .isBetween(-StrokeFont.DESCENT, StrokeFont.ASCENT);
          right = Math.max(right, points[i]);
        }
      }
      // The width is that of the shape; of the digits, the 1 has the most room.
      assertThat(right)
          .as("%c", character)
          .isGreaterThanOrEqualTo(character == ' ' ? 0 : .5 * glyph.width());
    }
  }

  @Test
  void shapesDiffer() {
    Map<String, Integer> seen = new HashMap<>();
    for (int character : GlyphTable.characters()) {
      Integer other = seen.put(shape(GlyphTable.of(character)), character);
      assertThat(other).as("%c", character).isNull();
    }
    assertThat(seen).doesNotContainKey(shape(GlyphTable.of(0x4e2d)));
  }

  @Test
  void digitsHaveOneWidth() {
    assertThat(IntStream.rangeClosed('0', '9').mapToDouble(c -> GlyphTable.of(c).width()))
        .containsOnly(GlyphTable.of('0').width());
  }

  @Test
  void unknownCharactersAreBoxes() {
    assertThat(GlyphTable.of(0x1F600)).isSameAs(GlyphTable.of(0xFFFD));
    Strokes strokes = new Strokes();
    StrokeFont.add(strokes, "\uD83D\uDE00\n", 0, 0, 14);
    assertThat(strokes.count()).isEqualTo(8);
  }

  @Test
  void textStandsOnItsBaseline() {
    Strokes strokes = new Strokes();
    StrokeFont.add(strokes, "HL", 10, 50, 28);
    double[] x = new double[2 * strokes.count()];
    double[] y = new double[x.length];
    for (int i = 0; i < x.length; i++) {
      x[i] = strokes.coordinate(i / 2, i % 2 * 2);
      y[i] = strokes.coordinate(i / 2, i % 2 * 2 + 1);
    }
    assertThat(IntStream.range(0, x.length).mapToDouble(i -> x[i]).min()).hasValue(10);
    assertThat(IntStream.range(0, y.length).mapToDouble(i -> y[i]).max()).hasValue(50);
    assertThat(IntStream.range(0, y.length).mapToDouble(i -> y[i]).min()).hasValue(22);
    assertThat(IntStream.range(0, x.length).mapToDouble(i -> x[i]).max().getAsDouble() - 10)
        .isCloseTo(StrokeFont.width("HL", 28), within(1e-12));
    assertThat(StrokeFont.width("", 28)).isZero();
  }
}
