package io.github.lumbre.stage.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class ChainsTest {
  @Test
  void segmentsThatMeetAreOneChain() {
    Strokes segments = new Strokes().add(0, 0, 4, 0).add(4, 3, 4, 0).add(4, 3, 9, 9);
    assertThat(Chains.of(segments)).containsExactly(new double[] {0, 0, 4, 0, 4, 3, 9, 9});
  }

  @Test
  void aRoundIsClosedAndHasNoPointsOnStraightLines() {
    Strokes square =
        new Strokes().add(0, 0, 2, 0).add(2, 0, 4, 0).add(4, 0, 4, 4).add(0, 4, 4, 4);
    square.add(0, 4, 0, 0);
    assertThat(Chains.of(square)).containsExactly(new double[] {0, 0, 4, 0, 4, 4, 0, 4, 0, 0});
  }

  /** A line goes on where two others end on it from both sides. */
  @Test
  void onlyStraightChainsPassAJunction() {
    Strokes cross = new Strokes().add(0, 0, 5, 0).add(5, 0, 5, 3).add(5, 0, 9, .5).add(5, 0, 4, -3);
    assertThat(Chains.of(cross)).hasSize(2);
    assertThat(Chains.of(cross).get(0)).containsExactly(0, 0, 5, 0, 9, .5);
    assertThat(Chains.of(new Strokes().add(1, 1, 1, 1))).isEmpty();
  }

  @Test
  void dashesContinueAroundCorners() {
    Strokes dashes = Polylines.dashed(List.of(new double[] {0, 0, 5, 0, 5, 5}), 3, 3);
    double[][] expected = {{0, 0, 3, 0}, {5, 1, 5, 4}};
    assertThat(dashes.count()).isEqualTo(2);
    for (int i = 0; i < 2; i++) {
      for (int k = 0; k < 4; k++) {
        assertThat(dashes.coordinate(i, k)).isEqualTo(expected[i][k]);
      }
    }
  }

  @Test
  void aPlaceHasOneLine() {
    UniqueLines lines = new UniqueLines();
    Strokes given = new Strokes().add(0, 0, 100, 0).add(150, .01, 50, 0).add(90, -5, 90, 5);
    given.add(20, 0, 80, 0).add(20, 1, 80, 1);
    assertThat(lines.add(given, 0).count()).isEqualTo(1);
    Strokes rest = lines.add(given, 1);
    assertThat(rest.count()).isEqualTo(1);
    assertThat(rest.coordinate(0, 0)).isEqualTo(150);
    assertThat(rest.coordinate(0, 2)).isCloseTo(100, within(1e-6));
    assertThat(lines.add(given, 2).count()).isEqualTo(1);
    assertThat(lines.add(given, 3).count()).isZero();
    assertThat(lines.add(given, 4).count()).isEqualTo(1);
  }

  @Test
  void regionsHaveOutlinesAndHoles() {
    long[] keys = new long[256];
    for (int i = 0; i < keys.length; i++) {
      boolean isHole = i % 16 >= 5 && i % 16 < 11 && i / 16 >= 5 && i / 16 < 11;
      boolean isInside = i % 16 >= 1 && i % 16 < 15 && i / 16 >= 1 && i / 16 < 15;
      keys[i] = isInside && !isHole ? 5 : -1;
    }
    List<double[]> outlines = Regions.outlines(16, keys, key -> key >= 0).get(5L);
    assertThat(outlines).hasSize(2);
    Areas areas = new Areas(outlines, 16, 16);
    assertThat(areas.shares(3)[8]).isEqualTo(1);
    assertThat(areas.shares(3)[0]).isZero();
    assertThat(areas.shares(8)[8]).isZero();
  }
}
