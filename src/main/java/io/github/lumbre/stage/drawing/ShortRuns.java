package io.github.lumbre.stage.drawing;

import java.util.ArrayList;
import java.util.List;

/**
 * Parts of chains that are visible between hidden ones, or hidden between visible ones, and too
 * short to be told from the others. A silhouette of a mesh has many where it ends inside of the
 * shape: there, its edges pass from triangle to triangle, in front of and behind others. Stateless.
 */
final class ShortRuns {
  /** Runs become as their neighbors below this length, in pixels. */
  private static final double SHORTEST = 2;

  /** The number of times that neighbors are joined. */
  private static final int PASSES = 8;

  private ShortRuns() {}

  /** A run from the first of its segments to before another one. */
  private record Run(int from, int end, double length, boolean isVisible) {}

  /**
   * Changes the sights of segments in short runs.
   *
   * @param isVisible whether each of the segments is visible
   */
  static void settle(Strokes segments, boolean[] isVisible) {
    for (int[] chain : new Chains(segments).numbers()) {
      boolean isChanged = true;
      for (int pass = 0; isChanged && pass < PASSES; pass++) {
        isChanged = settle(segments, chain, isVisible);
      }
    }
  }

  private static boolean settle(Strokes segments, int[] chain, boolean[] isVisible) {
    List<Run> runs = runs(segments, chain, isVisible);
    boolean isChanged = false;
    for (int i = 0; runs.size() > 1 && i < runs.size(); i++) {
      Run run = runs.get(i);
      if (run.length < SHORTEST) {
        for (int segment = run.from; segment < run.end; segment++) {
          isVisible[chain[segment]] = !run.isVisible;
        }
        isChanged = true;
        // The next run has grown by this one.
        i++;
      }
    }
    return isChanged;
  }

  private static List<Run> runs(Strokes segments, int[] chain, boolean[] isVisible) {
    List<Run> runs = new ArrayList<>();
    int from = 0;
    double length = 0;
    for (int i = 0; i < chain.length; i++) {
      length += segments.length(chain[i]);
      boolean isLast = i + 1 == chain.length;
      if (isLast || isVisible[chain[i + 1]] != isVisible[chain[from]]) {
        runs.add(new Run(from, i + 1, length, isVisible[chain[from]]));
        from = i + 1;
        length = 0;
      }
    }
    return runs;
  }
}
