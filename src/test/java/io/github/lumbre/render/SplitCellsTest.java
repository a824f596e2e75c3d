package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.SplitCells.Place;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the cells of pilot pixels. */
class SplitCellsTest {
  /** Returns places of a surface in a square of the frame. */
  private static List<Place> square(int surface, int left, int side) {
    List<Place> places = new ArrayList<>();
    for (int i = 0; i < side * side; i++) {
      places.add(new Place(surface, left + i % side, i / side));
    }
    return places;
  }

  @Test
  void surfacesHaveTheirOwnCells() {
    List<Place> places = square(3, 0, 7);
    places.addAll(square(-1, 7, 7));
    SplitCells cells = SplitCells.of(places);
    assertThat(cells.cell(new Place(3, 0, 0))).isEqualTo(cells.cell(new Place(3, 20, 20)));
    assertThat(cells.cell(new Place(3, 0, 0))).isNotEqualTo(cells.cell(new Place(-1, 0, 0)));
    // A surface that no pilot pixel sees has the cell of the rest, which no pixel trains.
    assertThat(cells.cell(new Place(99, 0, 0)))
        .isEqualTo(cells.cell(new Place(98, 9, 9)))
        .isNotEqualTo(cells.cell(new Place(3, 0, 0)))
        .isNotEqualTo(cells.cell(new Place(-1, 0, 0)))
        .isLessThan(cells.count());
  }

  /** Half a million surfaces and one pixel of each make one tree. */
  @Test
  void smallSurfacesShareCells() {
    List<Place> places = new ArrayList<>();
    for (int i = 0; i < 4096; i++) {
      places.add(new Place(100 * i, i % 64, i / 64));
    }
    SplitCells cells = SplitCells.of(places);
    assertThat(cells.count()).isBetween(32, 4096 / SplitCells.FEWEST);
    assertEveryCellHasEnough(cells, places);
    assertThat(cells.cell(new Place(0, 0, 0))).isEqualTo(cells.cell(new Place(7, 0, 0)));
  }

  @Test
  void everyCellOfALargeSurfaceHasEnoughPixels() {
    List<Place> places = square(0, 0, 40);
    SplitCells cells = SplitCells.of(places);
    assertThat(cells.count()).isGreaterThan(8);
    assertEveryCellHasEnough(cells, places);
  }

  private static void assertEveryCellHasEnough(SplitCells cells, List<Place> places) {
    int[] counts = new int[cells.count()];
    places.forEach(place -> counts[cells.cell(place)]++);
    for (int count : counts) {
      assertThat(count == 0 || count >= SplitCells.FEWEST).isTrue();
    }
  }
}
