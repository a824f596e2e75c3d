package io.github.lumbre.stage.drawing;

import io.github.lumbre.base.text.Quantities;
import io.github.lumbre.stage.drawing.LabelSheet.Tone;

/**
 * A bar of a round length in the lower right corner, with its length in the plane through the
 * middle of the model's box that faces the camera. Stateless.
 */
final class ScaleBar {
  /** The largest length, relative to the picture's width. */
  private static final double MOST = .25;

  private ScaleBar() {}

  /** Draws the bar if there is room. */
  static boolean draw(LabelSheet sheet, LabeledModel model) {
    double scale = model.isInFront() ? model.pixelsPerUnit() : 0;
    Rect frame = sheet.frame();
    double most = MOST * frame.right() / scale;
    if (!(scale > 0 && most > 0 && Double.isFinite(most))) {
      return false;
    }
    double length = Quantities.roundDown(most);
    String unit = model.unit().isEmpty() ? length == 1 ? "unit" : "units" : model.unit();
    String text = Quantities.text(length, unit);
    double capital = sheet.capital();
    double width = sheet.box(text, 0, 0, capital).width();
    double half = .5 * scale * length;
    double x = frame.right() - sheet.margin() - Math.max(half, .5 * width);
    double y = frame.bottom() - sheet.margin() - .4 * capital;
    if (width > 2 * MOST * frame.right()
        || !sheet.write(text, x, y - 1.6 * capital, capital, Tone.INK)) {
      return false;
    }
    double tick = .4 * capital;
    sheet
        .lines(Tone.INK, 1)
        .add(x - half, y, x + half, y)
        .add(x - half, y - tick, x - half, y + tick)
        .add(x + half, y - tick, x + half, y + tick);
    sheet.reserve(Rect.around(x, y, 2 * half + capital, 2 * capital));
    return true;
  }
}
