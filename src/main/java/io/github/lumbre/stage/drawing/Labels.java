package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/** The labels of one picture. Add them, then draw. Mutable; for one thread. */
public final class Labels {
  /** A picture whose edges have a smaller mean luminance gets bright labels. */
  private static final double DARK = .2;

  /** The height of the title in capitals of other labels. */
  private static final double TITLE = 1.6;

  private final LabelSheet sheet;
  private final List<String> missing = new ArrayList<>();
  private int unnamed;

  /** Creates labels for a picture of a size in pixels. */
  public Labels(int width, int height) {
    sheet = new LabelSheet(width, height);
  }

  /** Adds the name of the view, in the upper left corner; nothing if it has none. */
  public void addTitle(String title) {
    double size = TITLE * sheet.capital();
    double width = sheet.frame().right() - 2 * sheet.margin();
    String shown = sheet.shortened(title, size, width);
    Rect box = sheet.box(shown, 0, 0, size);
    add(
        "the view",
        () ->
            title.isEmpty()
                || !shown.isEmpty()
                    && sheet.write(
                        shown,
                        sheet.margin() - box.left(),
                        sheet.margin() - box.top(),
                        size,
                        LabelSheet.Tone.INK));
  }

  /** Adds the directions of the file's axes, in the lower left corner. */
  public void addAxes(LabeledModel model) {
    add("the axes", () -> AxesLabel.draw(sheet, model.axes()));
  }

  /** Adds a scale bar, in the lower right corner. */
  public void addScale(LabeledModel model) {
    add("the scale bar", () -> ScaleBar.draw(sheet, model));
  }

  /** Adds the edges of the box around the model. */
  public void addBox(LabeledModel model) {
    add("the box", () -> BoxLabel.drawEdges(sheet, model));
  }

  /** Adds the dimensions of the box around the model. Add the names of parts before. */
  public void addSizes(LabeledModel model) {
    add("the dimensions", () -> BoxLabel.drawSizes(sheet, model));
  }

  /** Adds the dimensions of a model as a text, in the upper right corner. */
  public void addSizes(String text) {
    double capital = sheet.capital();
    Rect box = sheet.box(text, 0, 0, capital);
    double x = sheet.frame().right() - sheet.margin() - box.right();
    double y = sheet.margin() - box.top();
    add("the dimensions", () -> sheet.write(text, x, y, capital, LabelSheet.Tone.INK));
  }

  /** Adds the names of visible parts. Add labels in the corners before. */
  public void addParts(PartMap map) {
    unnamed = PartNames.draw(sheet, map);
  }

  private void add(String name, BooleanSupplier draw) {
    if (!draw.getAsBoolean()) {
      missing.add(name);
    }
  }

  /** Returns what had no room, as ends of sentences: each begins with "no". */
  public List<String> leftOut() {
    List<String> notes = new ArrayList<>();
    if (!missing.isEmpty()) {
      notes.add("no room for " + String.join(", ", missing));
    }
    if (unnamed > 0) {
      notes.add("no names for " + unnamed + (unnamed == 1 ? " visible part" : " visible parts"));
    }
    return notes;
  }

  LabelSheet sheet() {
    return sheet;
  }

  /** Draws the labels: black with a white edge, or white with a black edge on dark pictures. */
  public void draw(Canvas canvas, Image picture) {
    sheet.draw(canvas, isDark(picture));
  }

  /** Draws the labels on a background of one color. */
  void draw(Easel easel, Rgb background) {
    sheet.draw(easel, background.luminance() < DARK);
  }

  /** Returns whether the edges of a picture are dark; what is transparent is taken as white. */
  private static boolean isDark(Image picture) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < picture.height(); y++) {
      boolean isEdge = y == 0 || y == picture.height() - 1;
      int step = isEdge ? 1 : Math.max(1, picture.width() - 1);
      for (int x = 0; x < picture.width(); x += step) {
        Rgb color = picture.pixel(x, y).clampedToOne();
        double alpha = picture.hasAlpha() ? picture.alpha(x, y) : 1;
        sum += alpha * color.luminance() + 1 - alpha;
        count++;
      }
    }
    return sum < DARK * count;
  }
}
