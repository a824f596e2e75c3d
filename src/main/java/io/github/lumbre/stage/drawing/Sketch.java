package io.github.lumbre.stage.drawing;

import io.github.lumbre.base.limit.internal.Interrupts;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * The lines of a picture, as segments by the numbers of their parts.
 *
 * @param visible lines in front of all surfaces
 * @param hidden lines behind surfaces; none unless they are wanted
 */
record Sketch(SortedMap<Integer, Strokes> visible, SortedMap<Integer, Strokes> hidden) {
  Sketch() {
    this(new TreeMap<>(), new TreeMap<>());
  }

  /** Returns the segments of a part to add to. */
  Strokes of(int part, boolean isVisible) {
    return (isVisible ? visible : hidden).computeIfAbsent(part, number -> new Strokes());
  }

  /**
   * Returns these lines, each place once: where lines coincide in the picture, a visible one wins
   * over a hidden one, and then a long one over a short one. Short runs of the lines of a part are
   * as what is around them.
   */
  Sketch settled() {
    Strokes all = new Strokes();
    List<Integer> parts = new ArrayList<>();
    BitSet seen = new BitSet();
    for (int part : both()) {
      addSettled(part, all, parts, seen);
    }
    double[] lengths = new double[all.count()];
    Arrays.setAll(lengths, all::length);
    Integer[] order = new Integer[lengths.length];
    Arrays.setAll(order, i -> i);
    Comparator<Integer> first = Comparator.comparing(i -> !seen.get(i));
    Arrays.sort(order, first.thenComparingDouble(i -> -lengths[i]));
    UniqueLines drawn = new UniqueLines();
    Strokes[] rests = new Strokes[order.length];
    for (int i : order) {
      Interrupts.check();
      rests[i] = drawn.add(all, i);
    }
    Sketch settled = new Sketch();
    for (int i = 0; i < rests.length; i++) {
      for (int rest = 0; rest < rests[i].count(); rest++) {
        settled.of(parts.get(i), seen.get(i)).add(rests[i], rest);
      }
    }
    return settled;
  }

  private SortedSet<Integer> both() {
    SortedSet<Integer> parts = new TreeSet<>(visible.keySet());
    parts.addAll(hidden.keySet());
    return parts;
  }

  private void addSettled(int part, Strokes all, List<Integer> parts, BitSet seen) {
    Strokes lines = new Strokes();
    Strokes front = visible.getOrDefault(part, new Strokes());
    Strokes behind = hidden.getOrDefault(part, new Strokes());
    for (int i = 0; i < front.count(); i++) {
      lines.add(front, i);
    }
    for (int i = 0; i < behind.count(); i++) {
      lines.add(behind, i);
    }
    boolean[] isVisible = new boolean[lines.count()];
    Arrays.fill(isVisible, 0, front.count(), true);
    ShortRuns.settle(lines, isVisible);
    for (int i = 0; i < lines.count(); i++) {
      seen.set(all.count(), isVisible[i]);
      all.add(lines, i);
      parts.add(part);
    }
  }
}
