package io.github.lumbre.stage.drawing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Lines in a picture of which no two coincide. Mutable. */
final class UniqueLines {
  /** Lines that are nearer to each other all along are one line, in pixels. */
  private static final double NEAR = .05;

  /** The largest tangent of the angle between lines that may be one. */
  private static final double PARALLEL = .2;

  /** The side of the squares in which lines are found, in pixels. */
  private static final double CELL = 16;

  private static final int[] NONE = {0};

  private final Strokes drawn = new Strokes();

  /** The count and then the numbers of the lines that pass each square. */
  private final Map<Long, int[]> cells = new HashMap<>();

  /** The number of the added line with which each line was compared last. */
  private int[] compared = {};

  private int query;
  private final List<double[]> covered = new ArrayList<>();

  /**
   * Adds a segment, and returns what is left of it without the parts where lines were drawn before:
   * nothing of one without a length.
   */
  Strokes add(Strokes segments, int i) {
    Strokes left = new Strokes();
    Line line = Line.of(segments, i);
    if (line.length > 0) {
      add(line, left);
    }
    return left;
  }

  private void add(Line line, Strokes left) {
    covered.clear();
    query++;
    visit(line, this::compare);
    covered.sort(Comparator.comparingDouble(range -> range[0]));
    double begin = 0;
    for (double[] range : covered) {
      put(line, begin, range[0], left);
      begin = Math.max(begin, range[1]);
    }
    put(line, begin, line.length, left);
  }

  /** Adds a range of a line, unless it is a rest too short to be seen. */
  private void put(Line line, double from, double to, Strokes left) {
    boolean isWhole = from == 0 && to == line.length;
    if (isWhole || to - from > 2 * NEAR) {
      double[] ends = line.part(from, to);
      left.add(ends[0], ends[1], ends[2], ends[3]);
      drawn.add(ends[0], ends[1], ends[2], ends[3]);
      if (compared.length < drawn.capacity()) {
        compared = Arrays.copyOf(compared, drawn.capacity());
      }
      visit(Line.of(drawn, drawn.count() - 1), this::enter);
    }
  }

  /** Finds out where the lines of a square are those of another one. */
  private void compare(Line line, long cell) {
    int[] numbers = cells.getOrDefault(cell, NONE);
    for (int i = 1; i <= numbers[0]; i++) {
      int number = numbers[i];
      if (compared[number] != query) {
        compared[number] = query;
        double[] range = line.rangeBeside(drawn, number);
        if (range.length > 0) {
          covered.add(range);
        }
      }
    }
  }

  /** Enters the last line into a square. */
  private void enter(Line line, long cell) {
    int number = drawn.count() - 1;
    int[] numbers = cells.computeIfAbsent(cell, key -> new int[4]);
    if (numbers[0] > 0 && numbers[numbers[0]] == number) {
      return;
    }
    if (numbers[0] + 1 == numbers.length) {
      numbers = Arrays.copyOf(numbers, 2 * numbers.length);
      cells.put(cell, numbers);
    }
    numbers[++numbers[0]] = number;
  }

  /** Visits a square. */
  private interface Visitor {
    void visit(Line line, long cell);
  }

  /** Visits the squares that a line passes, or that are within a pixel, some of them twice. */
  private static void visit(Line line, Visitor visitor) {
    int steps = (int) Math.ceil(line.length / CELL) + 1;
    for (int i = 0; i < steps; i++) {
      double from = line.length * i / steps;
      double to = line.length * (i + 1) / steps;
      long left = cell(line.x + Math.min(from * line.dx, to * line.dx) - 1);
      long right = cell(line.x + Math.max(from * line.dx, to * line.dx) + 1);
      long top = cell(line.y + Math.min(from * line.dy, to * line.dy) - 1);
      long bottom = cell(line.y + Math.max(from * line.dy, to * line.dy) + 1);
      for (long x = left; x <= right; x++) {
        for (long y = top; y <= bottom; y++) {
          visitor.visit(line, Strokes.key(x, y));
        }
      }
    }
  }

  private static long cell(double coordinate) {
    return (long) Math.floor(coordinate / CELL);
  }

  /** A segment from (x, y) in the unit direction (dx, dy). */
  private record Line(double x, double y, double dx, double dy, double length, double[] ends) {
    static Line of(Strokes strokes, int i) {
      double[] ends = new double[4];
      Arrays.setAll(ends, index -> strokes.coordinate(i, index));
      double dx = ends[2] - ends[0];
      double dy = ends[3] - ends[1];
      double length = Math.sqrt(dx * dx + dy * dy);
      boolean isLine = length > 1e-6 && Double.isFinite(length);
      return isLine
          ? new Line(ends[0], ends[1], dx / length, dy / length, length, ends)
          : new Line(ends[0], ends[1], 1, 0, 0, ends);
    }

    /** Returns the ends of a range; those of the whole line keep their bits. */
    double[] part(double from, double to) {
      double[] part = ends.clone();
      if (from > 0) {
        part[0] = x + from * dx;
        part[1] = y + from * dy;
      }
      if (to < length) {
        part[2] = x + to * dx;
        part[3] = y + to * dy;
      }
      return part;
    }

    /** Returns the range where another line is the same one; empty if there is none. */
    double[] rangeBeside(Strokes strokes, int number) {
      double fromX = strokes.coordinate(number, 0) - x;
      double fromY = strokes.coordinate(number, 1) - y;
      double toX = strokes.coordinate(number, 2) - x;
      double toY = strokes.coordinate(number, 3) - y;
      double from = fromX * dx + fromY * dy;
      double to = toX * dx + toY * dy;
      double fromOff = fromY * dx - fromX * dy;
      double toOff = toY * dx - toX * dy;
      double slope = (toOff - fromOff) / (to - from);
      if (!(Math.abs(slope) <= PARALLEL)) {
        return new double[0];
      }
      double low = Math.max(0, Math.min(from, to));
      double high = Math.min(length, Math.max(from, to));
      double lowOff = fromOff + (low - from) * slope;
      double highOff = fromOff + (high - from) * slope;
      boolean isBeside = high > low && Math.max(Math.abs(lowOff), Math.abs(highOff)) <= NEAR;
      return isBeside ? new double[] {low, high} : new double[0];
    }
  }
}
