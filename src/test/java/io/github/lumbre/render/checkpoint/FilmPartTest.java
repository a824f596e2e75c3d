package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Tests the overlap and the union of parts of a film. */
class FilmPartTest {
  /** A sample, identified by its pixel in the full frame and its number. */
  private record Sample(int x, int y, int number) {}

  /** All windows in a frame of 3x3 pixels. */
  private static List<Crop> windows() {
    List<Crop> windows = new ArrayList<>();
    for (int x = 0; x < 3; x++) {
      for (int y = 0; y < 3; y++) {
        for (int width = 1; width <= 3 - x; width++) {
          for (int height = 1; height <= 3 - y; height++) {
            windows.add(new Crop(x, y, width, height));
          }
        }
      }
    }
    return windows;
  }

  /** All parts of a window with the first sample and the number of samples from 0 to 2. */
  private static List<FilmPart> parts(Crop window) {
    List<FilmPart> parts = new ArrayList<>();
    for (int first = 0; first <= 2; first++) {
      for (int most = 0; most <= 2; most++) {
        parts.add(new FilmPart(window, first, most, most));
      }
    }
    return parts;
  }

  private static Set<Sample> samples(FilmPart part) {
    Set<Sample> samples = new HashSet<>();
    Crop window = part.window();
    for (int x = window.x(); x < window.x() + window.width(); x++) {
      for (int y = window.y(); y < window.y() + window.height(); y++) {
        for (int number = part.first(); number < part.end(); number++) {
          samples.add(new Sample(x, y, number));
        }
      }
    }
    return samples;
  }

  @Test
  void partsOverlapIfTheyHaveASampleInCommon() {
    for (Crop window : windows()) {
      for (Crop otherWindow : windows()) {
        FilmPart part = new FilmPart(window, 1, 2, 2);
        for (int first = 0; first <= 3; first++) {
          FilmPart other = new FilmPart(otherWindow, first, 1, 1);
          Set<Sample> common = samples(part);
          common.retainAll(samples(other));
          assertThat(part.overlaps(other)).as("%s, %s", part, other).isEqualTo(!common.isEmpty());
          assertThat(other.overlaps(part)).as("%s, %s", other, part).isEqualTo(!common.isEmpty());
        }
      }
    }
  }

  /** The union of two disjoint parts has exactly the samples of both. */
  @Test
  void joinedPartsHaveTheSamplesOfBoth() {
    int joins = 0;
    for (Crop window : windows()) {
      for (Crop otherWindow : windows()) {
        for (FilmPart part : parts(window)) {
          for (FilmPart other : parts(otherWindow)) {
            Optional<FilmPart> both = part.joined(other);
            if (both.isPresent() && !part.overlaps(other)) {
              Set<Sample> expected = samples(part);
              expected.addAll(samples(other));
              if (part.most() == other.most() || window.equals(otherWindow)) {
                assertThat(samples(both.get())).as("%s, %s", part, other).isEqualTo(expected);
                joins++;
              }
            }
          }
        }
      }
    }
    assertThat(joins).isPositive();
  }

  /** A window is cut at each column and row; the right or lower half joins the other one. */
  @Test
  void neighboringWindowsJoinIfTheyFillARectangle() {
    for (Crop whole : windows()) {
      FilmPart part = new FilmPart(whole, 1, 2, 2);
      for (int cut = 1; cut < whole.width(); cut++) {
        Crop left = new Crop(whole.x(), whole.y(), cut, whole.height());
        Crop right = new Crop(whole.x() + cut, whole.y(), whole.width() - cut, whole.height());
        assertThat(new FilmPart(left, 1, 2, 2).joined(new FilmPart(right, 1, 2, 2))).contains(part);
      }
      for (int cut = 1; cut < whole.height(); cut++) {
        Crop top = new Crop(whole.x(), whole.y(), whole.width(), cut);
        Crop bottom = new Crop(whole.x(), whole.y() + cut, whole.width(), whole.height() - cut);
        assertThat(new FilmPart(top, 1, 2, 2).joined(new FilmPart(bottom, 1, 2, 2))).contains(part);
      }
    }
  }

  @Test
  void windowsWithAGapOrAnEdgeOfOtherLengthDoNotJoin() {
    FilmPart part = part(2, 2, 2, 2);
    for (FilmPart other :
        List.of(
            part(5, 2, 2, 2), // a column between them
            part(4, 3, 2, 2), // one row lower
            part(4, 2, 2, 3), // higher
            part(2, 5, 2, 2), // a row between them
            part(3, 4, 2, 2), // one column to the right
            part(2, 4, 3, 2), // wider
            part(4, 4, 2, 2))) { // they touch at a corner
      assertThat(part.joined(other)).as(other.toString()).isEmpty();
    }
  }

  private static FilmPart part(int x, int y, int width, int height) {
    return new FilmPart(new Crop(x, y, width, height), 0, 1, 1);
  }

  @Test
  void joinedWindowsKnowTheFewestAndTheMostSamplesOfBoth() {
    Crop left = new Crop(0, 0, 1, 2);
    Crop right = new Crop(1, 0, 2, 2);
    Crop both = new Crop(0, 0, 3, 2);
    assertThat(new FilmPart(left, 5, 2, 9).joined(new FilmPart(right, 5, 3, 4)))
        .contains(new FilmPart(both, 5, 2, 9));
    assertThat(new FilmPart(left, 5, 3, 4).joined(new FilmPart(right, 5, 2, 9)))
        .contains(new FilmPart(both, 5, 2, 9));
    assertThat(new FilmPart(left, 5, 3, 4).joined(new FilmPart(right, 6, 3, 4))).isEmpty();
  }

  /** If pixels had different sample counts, the joined sample numbers would have gaps. */
  @Test
  void samplesThatFollowJoinIfAllPixelsAreAsFar() {
    Crop window = new Crop(0, 0, 2, 2);
    FilmPart next = new FilmPart(window, 7, 1, 3);
    assertThat(new FilmPart(window, 4, 3, 3).joined(next)).contains(new FilmPart(window, 4, 4, 6));
    assertThat(new FilmPart(window, 4, 2, 3).joined(next)).isEmpty();
    assertThat(new FilmPart(window, 4, 2, 2).joined(next)).isEmpty();
  }

  @Test
  void hullIsTheSmallestWindowThatHoldsBoth() {
    for (Crop a : windows()) {
      for (Crop b : windows()) {
        Crop hull = FilmPart.hull(a, b);
        Set<Sample> pixels = samples(new FilmPart(a, 0, 1, 1));
        pixels.addAll(samples(new FilmPart(b, 0, 1, 1)));
        assertThat(hull.x()).isEqualTo(pixels.stream().mapToInt(Sample::x).min().orElseThrow());
        assertThat(hull.y()).isEqualTo(pixels.stream().mapToInt(Sample::y).min().orElseThrow());
        assertThat(hull.x() + hull.width() - 1)
            .isEqualTo(pixels.stream().mapToInt(Sample::x).max().orElseThrow());
        assertThat(hull.y() + hull.height() - 1)
            .isEqualTo(pixels.stream().mapToInt(Sample::y).max().orElseThrow());
      }
    }
  }

  @Test
  void countsAreInOrderAndNumbersAreInts() {
    Crop window = new Crop(0, 0, 1, 1);
    assertThat(new FilmPart(window, 0, 0, 0).end()).isZero();
    assertThat(new FilmPart(window, 1, 0, Integer.MAX_VALUE - 1).end())
        .isEqualTo(Integer.MAX_VALUE);
    for (int[] bad : new int[][] {{-1, 1, 1}, {0, -1, 1}, {0, 2, 1}, {1, 0, Integer.MAX_VALUE}}) {
      assertThatThrownBy(() -> new FilmPart(window, bad[0], bad[1], bad[2]))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("first " + bad[0] + ", " + bad[1] + ", " + bad[2]);
    }
  }
}
