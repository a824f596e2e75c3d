package io.github.lumbre.model.section;

import io.github.lumbre.math.Vec3;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Edges that triangles pass more often in one direction than in the other. An edge is divided where
 * a shorter one leads along it, so that a long edge on one side closes a chain of short ones on the
 * other: readers drop the triangles without area that exporters put between them. Mutable;
 * not reusable.
 */
final class OpenEdges {
  /** A vertex lies on an edge within this distance, in steps of the grid of the places. */
  private static final double STEP = 1;

  /** More edges than this are not divided: their meshes are open, as those of scans are. */
  private static final int MOST = 1 << 16;

  /** The most pairs of edges at places that are compared, for each edge. */
  private static final long STEPS = 64;

  private final double[] places;

  /** For each end, the other ends, and how much more often they are reached than left. */
  private final Map<Integer, Map<Integer, Integer>> edges = new LinkedHashMap<>();

  /** An end of each edge that was added. */
  private final BitSet all = new BitSet();

  private int count;

  /**
   * @param places three whole numbers for each place: steps of a grid
   */
  OpenEdges(double... places) {
    this.places = places;
  }

  /** Adds an edge that is passed some times more often from one place to the other than back. */
  void add(int from, int to, int times) {
    all.set(from);
    if (++count <= MOST) {
      merge(from, to, times);
    }
  }

  private void merge(int from, int to, int times) {
    mergeOne(from, to, times);
    mergeOne(to, from, -times);
  }

  private void mergeOne(int from, int to, int times) {
    Map<Integer, Integer> others = edges.computeIfAbsent(from, f -> new LinkedHashMap<>());
    if (others.merge(to, times, Integer::sum) == 0) {
      others.remove(to);
    }
  }

  /** Returns places at the ends of what stays open after edges are divided, one of each edge. */
  IntStream ends() {
    if (count > MOST) {
      return all.stream();
    }
    Deque<Integer> left = new ArrayDeque<>(edges.keySet());
    long steps = STEPS * count;
    while (!left.isEmpty()) {
      int place = left.pop();
      List<Integer> others = List.copyOf(edges.get(place).keySet());
      steps -= (long) others.size() * others.size();
      if (steps < 0) {
        break;
      }
      divide(place, others, left);
    }
    return edges.keySet().stream().filter(p -> !edges.get(p).isEmpty()).mapToInt(p -> p);
  }

  /** Divides the first edge at a place along which a shorter one leads. */
  private void divide(int place, List<Integer> others, Deque<Integer> left) {
    for (int far : others) {
      for (int near : others) {
        if (isOn(near, place, far)) {
          int times = edges.get(place).get(far);
          merge(place, far, -times);
          merge(place, near, times);
          merge(near, far, times);
          left.addAll(List.of(place, near, far));
          return;
        }
      }
    }
  }

  /** Returns whether a place lies within an edge. */
  private boolean isOn(int place, int from, int to) {
    Vec3 along = place(to).minus(place(from));
    Vec3 part = place(place).minus(place(from));
    double share = part.dot(along);
    return share > 0
        && share < along.dot(along)
        && along.cross(part).length() <= STEP * along.length();
  }

  private Vec3 place(int number) {
    return new Vec3(places[3 * number], places[3 * number + 1], places[3 * number + 2]);
  }
}
