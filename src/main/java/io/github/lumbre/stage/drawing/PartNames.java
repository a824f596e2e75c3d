package io.github.lumbre.stage.drawing;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.stage.drawing.LabelSheet.Tone;
import io.github.lumbre.stage.drawing.PartMap.Visible;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Names of parts in two columns, at the left and the right edge of the picture, with lines to a
 * visible pixel of each part. The lines do not cross. Stateless.
 */
final class PartNames {
  /** The largest number of names. */
  static final int MOST = 20;

  /** The largest width of a name, relative to the picture's width. */
  private static final double WIDEST = .2;

  private PartNames() {}

  /** A name in a column, and the pixel that its line leads to. Mutable. */
  private static final class Entry {
    private final String name;
    private final double x;
    private final double y;
    private double row;

    Entry(String name, Visible part) {
      this.name = name;
      x = part.x() + .5;
      y = part.y() + .5;
    }
  }

  /** Draws names and lines; returns how many of the visible parts have no name. */
  static int draw(LabelSheet sheet, PartMap map) {
    double width = sheet.frame().right();
    double widest = WIDEST * width;
    double edge = sheet.margin() + widest + sheet.capital();
    List<Optional<Visible>> visible =
        map.visible((int) Math.ceil(edge), (int) Math.floor(width - edge));
    double step = 1.1 * sheet.box("", 0, 0, sheet.capital()).height();
    double[] left = sheet.room(sheet.margin(), edge);
    double[] right = sheet.room(width - edge, width - sheet.margin());
    int leftRows = rows(left, step);
    int rightRows = rows(right, step);
    List<Entry> entries = new ArrayList<>();
    for (Optional<Visible> part : visible) {
      if (part.isPresent() && entries.size() < Math.min(MOST, leftRows + rightRows)) {
        String name = PrintableText.escaped(part.get().name());
        String shown = sheet.shortened(name, sheet.capital(), widest);
        if (!shown.isEmpty()) {
          entries.add(new Entry(shown, part.get()));
        }
      }
    }
    entries.sort(Comparator.comparingDouble(entry -> entry.x));
    long near = entries.stream().filter(entry -> entry.x < .5 * width).count();
    int split = (int) Math.min(leftRows, Math.max(near, entries.size() - rightRows));
    int drawn =
        column(sheet, entries.subList(0, split), left, step, false)
            + column(sheet, entries.subList(split, entries.size()), right, step, true);
    return visible.size() - drawn;
  }

  private static int rows(double[] room, double step) {
    return (int) Math.max(0, Math.floor((room[1] - room[0]) / step));
  }

  /** Draws a column of names in a range of y; returns how many. */
  private static int column(
      LabelSheet sheet, List<Entry> entries, double[] room, double step, boolean isRight) {
    List<Entry> column = new ArrayList<>(entries);
    column.sort(Comparator.comparingDouble(entry -> entry.y));
    double most =
        column.stream()
            .mapToDouble(entry -> sheet.box(entry.name, 0, 0, sheet.capital()).width())
            .max()
            .orElse(0);
    double inner = sheet.margin() + most;
    double edge = isRight ? sheet.frame().right() - inner : inner;
    double start = edge + (isRight ? -.2 : .2) * sheet.capital();
    double turn = edge + (isRight ? -.6 : .6) * sheet.capital();
    spread(column, room[0] + .5 * step, room[1] - .5 * step, step);
    uncross(column, turn);
    int drawn = 0;
    for (Entry entry : column) {
      double half = .5 * sheet.box(entry.name, 0, 0, sheet.capital()).width();
      double middle = edge + (isRight ? half : -half);
      if (sheet.write(entry.name, middle, entry.row, sheet.capital(), Tone.INK)) {
        sheet.lead(start, entry.row, turn, entry.row);
        sheet.lead(turn, entry.row, entry.x, entry.y);
        sheet.lines(Tone.INK, 2.5).add(entry.x, entry.y, entry.x, entry.y);
        drawn++;
      }
    }
    return drawn;
  }

  /** Gives each name a row near its pixel, in the same order, a step or more apart. */
  private static void spread(List<Entry> column, double top, double bottom, double step) {
    double next = top;
    for (Entry entry : column) {
      entry.row = Math.max(next, entry.y);
      next = entry.row + step;
    }
    double last = bottom;
    for (int i = column.size() - 1; i >= 0; i--) {
      column.get(i).row = Math.min(column.get(i).row, last);
      last = column.get(i).row - step;
    }
  }

  /** Exchanges the rows of lines that cross; each exchange makes the lines shorter. */
  private static void uncross(List<Entry> column, double x) {
    boolean isDone = false;
    for (int round = 0; !isDone && round < MOST * MOST; round++) {
      isDone = true;
      for (Entry a : column) {
        for (Entry b : column) {
          if (a.row < b.row && cross(a, b, x)) {
            double row = a.row;
            a.row = b.row;
            b.row = row;
            isDone = false;
          }
        }
      }
    }
  }

  /** Returns whether the lines of two names cross; the first name has the upper row. */
  private static boolean cross(Entry a, Entry b, double x) {
    // They do if the first one is lower where the shorter line ends.
    double end = Math.abs(a.x - x) < Math.abs(b.x - x) ? a.x : b.x;
    return at(a, x, end) > at(b, x, end);
  }

  private static double at(Entry entry, double from, double x) {
    return entry.row + (entry.y - entry.row) * (x - from) / (entry.x - from);
  }
}
