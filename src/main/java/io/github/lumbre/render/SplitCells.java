package io.github.lumbre.render;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Cells of pixels that are alike: the same surface is seen first, in the same part of the frame.
 * Each surface with enough pilot pixels has a k-d tree over the frame, and all other surfaces share
 * one. Immutable.
 */
final class SplitCells {
  /** The smallest number of pilot pixels of a cell; estimates of fewer are too uncertain. */
  static final int FEWEST = 48;

  private final Map<Integer, Node> surfaces;
  private final Node others;
  private final int count;

  private SplitCells(Map<Integer, Node> surfaces, Node others, int count) {
    this.surfaces = surfaces;
    this.others = others;
    this.count = count;
  }

  /**
   * A pixel.
   *
   * @param surface number of the primitive that is seen first, or -1
   * @param x column in the full frame, and y row
   */
  record Place(int surface, int x, int y) {
    private int along(boolean isVertical) {
      return isVertical ? y : x;
    }
  }

  /** A part of the frame: either a cell or two parts. */
  private interface Node {
    int cell(Place place);
  }

  /** Returns the cells of some pilot pixels. */
  static SplitCells of(List<Place> places) {
    Map<Integer, List<Place>> bySurface = new TreeMap<>();
    places.forEach(p -> bySurface.computeIfAbsent(p.surface(), s -> new ArrayList<>()).add(p));
    Builder builder = new Builder();
    List<Place> rest = new ArrayList<>();
    Map<Integer, Node> surfaces = new TreeMap<>();
    bySurface.forEach(
        (surface, seen) -> {
          if (seen.size() < FEWEST) {
            rest.addAll(seen);
          } else {
            surfaces.put(surface, builder.node(seen));
          }
        });
    return new SplitCells(surfaces, builder.node(rest), builder.cells);
  }

  /** Numbers the cells. Mutable. */
  private static final class Builder {
    private int cells;

    Node node(List<Place> places) {
      if (places.size() < 2 * FEWEST) {
        int cell = cells++;
        return place -> cell;
      }
      boolean isVertical = extent(places, true) > extent(places, false);
      List<Place> sorted = new ArrayList<>(places);
      sorted.sort(Comparator.comparingInt(place -> place.along(isVertical)));
      int middle = sorted.get(sorted.size() / 2).along(isVertical);
      List<Place> low = sorted.stream().filter(p -> p.along(isVertical) < middle).toList();
      List<Place> high = sorted.stream().filter(p -> p.along(isVertical) >= middle).toList();
      if (low.size() < FEWEST || high.size() < FEWEST) {
        int cell = cells++;
        return place -> cell;
      }
      Node first = node(low);
      Node second = node(high);
      return place -> (place.along(isVertical) < middle ? first : second).cell(place);
    }

    private static int extent(List<Place> places, boolean isVertical) {
      int low = places.stream().mapToInt(p -> p.along(isVertical)).min().orElseThrow();
      int high = places.stream().mapToInt(p -> p.along(isVertical)).max().orElseThrow();
      return high - low;
    }
  }

  /** Returns the number of cells. */
  int count() {
    return count;
  }

  /** Returns the number of a pixel's cell, from 0. */
  int cell(Place place) {
    return surfaces.getOrDefault(place.surface(), others).cell(place);
  }
}
