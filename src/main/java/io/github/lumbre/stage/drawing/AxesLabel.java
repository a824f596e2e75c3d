package io.github.lumbre.stage.drawing;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.stage.drawing.LabelSheet.Tone;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** The directions of the file's axes, in the lower left corner. Stateless. */
final class AxesLabel {
  private static final List<Tone> TONES = List.of(Tone.X, Tone.Y, Tone.Z);
  private static final double LENGTH = 3;

  /** The distance of letters from the ends of their axes, in capitals. */
  private static final double GAP = 1.5;

  /** Shorter axes point to the viewer or away: their letters are on the other side. */
  private static final double END_ON = .4;

  /** The largest part of the picture's shorter side that the axes may take. */
  private static final double MOST = .34;

  private AxesLabel() {}

  /** Draws the axes if there is room. */
  static boolean draw(LabelSheet sheet, List<Vec3> axes) {
    double capital = sheet.capital();
    double reach = (LENGTH + GAP + 1) * capital;
    Rect frame = sheet.frame();
    double x = reach + .3 * capital;
    double y = frame.bottom() - reach - .3 * capital;
    Rect box = Rect.around(x, y, 2 * reach, 2 * reach);
    if (2 * reach > MOST * Math.min(frame.right(), frame.bottom()) || !sheet.isFree(box)) {
      return false;
    }
    // The longest first: the letters of the others give way.
    IntStream.range(0, TONES.size())
        .boxed()
        .sorted(Comparator.comparingDouble((Integer i) -> -seen(axes.get(i))))
        .forEach(i -> draw(sheet, axes, i, x, y));
    sheet.reserve(box);
    return true;
  }

  /** Returns the length of an axis in the picture, at most 1. */
  private static double seen(Vec3 axis) {
    return Math.sqrt(axis.x() * axis.x() + axis.y() * axis.y());
  }

  private static void draw(LabelSheet sheet, List<Vec3> axes, int number, double x, double y) {
    Vec3 axis = axes.get(number);
    double length = LENGTH * sheet.capital();
    double endX = x + length * axis.x();
    double endY = y - length * axis.y();
    Tone tone = TONES.get(number);
    sheet.lines(tone, 1.6).add(x, y, endX, endY);
    boolean isEndOn = seen(axis) < END_ON;
    Vec3 sum = axes.get(0).plus(axes.get(1)).plus(axes.get(2));
    Vec3 toward = isEndOn ? axis.minus(sum) : axis;
    double step = GAP * sheet.capital() / Math.max(seen(toward), .1);
    double fromX = isEndOn ? x : endX;
    double fromY = isEndOn ? y : endY;
    // Around the end, beginning in the direction of the axis.
    double[][] turns = {{1, 0}, {.7, .7}, {.7, -.7}, {0, 1}, {0, -1}};
    for (double[] turn : turns) {
      double letterX = fromX + step * (turn[0] * toward.x() + turn[1] * toward.y());
      double letterY = fromY - step * (turn[0] * toward.y() - turn[1] * toward.x());
      if (sheet.write(tone.name(), letterX, letterY, sheet.capital(), tone)) {
        return;
      }
    }
  }
}
