package io.github.lumbre.stage.drawing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.stream.IntStream;

/** Lines through points, given by x and y of each. Stateless. */
final class Polylines {
  private Polylines() {}

  /**
   * Returns a line without the points that are within a distance of the line between others
   * (Douglas and Peucker 1973). It keeps its ends.
   */
  static double[] simplified(double[] line, double distance) {
    int count = line.length / 2;
    BitSet kept = new BitSet(count);
    kept.set(0);
    kept.set(count - 1);
    Deque<int[]> open = new ArrayDeque<>();
    open.push(new int[] {0, count - 1});
    while (!open.isEmpty()) {
      int[] range = open.pop();
      int farthest = farthest(line, range[0], range[1], distance);
      if (farthest > 0) {
        kept.set(farthest);
        open.push(new int[] {range[0], farthest});
        open.push(new int[] {farthest, range[1]});
      }
    }
    return kept.stream()
        .flatMap(i -> IntStream.of(2 * i, 2 * i + 1))
        .mapToDouble(i -> line[i])
        .toArray();
  }

  /** Returns the point that is farthest from a line between two others; 0 if all are near. */
  private static int farthest(double[] line, int first, int last, double distance) {
    double x = line[2 * first];
    double y = line[2 * first + 1];
    double dx = line[2 * last] - x;
    double dy = line[2 * last + 1] - y;
    double square = dx * dx + dy * dy;
    double most = distance * distance;
    int farthest = 0;
    for (int i = first + 1; i < last; i++) {
      double px = line[2 * i] - x;
      double py = line[2 * i + 1] - y;
      double along = square > 0 ? Math.max(0, Math.min((px * dx + py * dy) / square, 1)) : 0;
      double offX = px - along * dx;
      double offY = py - along * dy;
      if (offX * offX + offY * offY > most) {
        most = offX * offX + offY * offY;
        farthest = i;
      }
    }
    return farthest;
  }

  /** Returns segments as lines: each goes on in the next one if it begins where this one ends. */
  static List<double[]> joined(Strokes segments) {
    List<double[]> lines = new ArrayList<>();
    double[] line = {};
    for (int i = 0; i < segments.count(); i++) {
      int last = line.length - 2;
      boolean isNext =
          last > 0
              && line[last] == segments.coordinate(i, 0)
              && line[last + 1] == segments.coordinate(i, 1);
      if (!isNext) {
        line = new double[] {segments.coordinate(i, 0), segments.coordinate(i, 1)};
        lines.add(line);
      }
      line = Arrays.copyOf(line, line.length + 2);
      line[line.length - 2] = segments.coordinate(i, 2);
      line[line.length - 1] = segments.coordinate(i, 3);
      lines.set(lines.size() - 1, line);
    }
    return lines;
  }

  /** Returns dashes along lines; each line begins with a dash, which goes on around its corners. */
  static Strokes dashed(Iterable<double[]> lines, double dash, double gap) {
    Strokes dashes = new Strokes();
    for (double[] line : lines) {
      double at = 0;
      for (int i = 0; i + 3 < line.length; i += 2) {
        at = addDashes(line, i, at, dash, gap, dashes);
      }
    }
    return dashes;
  }

  /** Adds the dashes of a segment that begins at a place of the pattern; returns the next place. */
  private static double addDashes(
      double[] line, int i, double start, double dash, double gap, Strokes dashes) {
    double dx = line[i + 2] - line[i];
    double dy = line[i + 3] - line[i + 1];
    double length = Math.sqrt(dx * dx + dy * dy);
    double period = dash + gap;
    for (double begin = -start; begin < length; begin += period) {
      double from = Math.max(0, begin) / length;
      double to = Math.min(length, begin + dash) / length;
      if (to > from) {
        dashes.add(
            line[i] + from * dx, line[i + 1] + from * dy, line[i] + to * dx, line[i + 1] + to * dy);
      }
    }
    return (start + length) % period;
  }
}
