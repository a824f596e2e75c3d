package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Rgb;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The labels of a picture before they are drawn. Texts are placed only inside the picture and where
 * no other text is. Mutable; for one thread.
 */
final class LabelSheet {
  /** The shorter side of the picture is this many capitals high. */
  private static final double CAPITALS_PER_SIDE = 55;

  /** The least height of capitals in pixels that can be read. */
  private static final double LEAST_CAPITAL = 7;

  private static final double CAPITALS_PER_PEN = 9;
  private static final double CAPITALS_PER_HALO = 6;

  /** Fewer letters before the dots say nothing. */
  private static final int LEAST_LETTERS = 4;

  private static final String DOTS = "...";

  private final Rect frame;
  private final double capital;
  private final Map<Ink, Strokes> strokes = new LinkedHashMap<>();
  private final List<Text> texts = new ArrayList<>();
  private final List<Rect> taken = new ArrayList<>();

  /** Points of each line that dimensions may cross and their texts may not. */
  private final List<List<Rect>> leaders = new ArrayList<>();

  /** A text, and the rectangle that it covers with its halo. */
  record Text(String text, Rect box) {}

  /** The colors of labels: of texts and lines, and of the three axes. */
  enum Tone {
    INK(Rgb.BLACK, Rgb.WHITE),
    X(new Rgb(.6, 0, 0), new Rgb(1, .25, .2)),
    Y(new Rgb(0, .25, 0), new Rgb(.2, .9, .2)),
    Z(new Rgb(0, .06, .7), new Rgb(.25, .5, 1));

    private final Rgb onBright;
    private final Rgb onDark;

    Tone(Rgb onBright, Rgb onDark) {
      this.onBright = onBright;
      this.onDark = onDark;
    }
  }

  /**
   * A pen for labels.
   *
   * @param edge width of the edge in the other color, on each side
   */
  private record Ink(Tone tone, double width, double edge) {}

  LabelSheet(int width, int height) {
    frame = new Rect(0, 0, width, height);
    capital = Math.max(LEAST_CAPITAL, Math.min(width, height) / CAPITALS_PER_SIDE);
  }

  Rect frame() {
    return frame;
  }

  /** Returns the height of capitals in pixels. */
  double capital() {
    return capital;
  }

  /** Returns the distance of labels from the edges of the picture. */
  double margin() {
    return 1.2 * capital;
  }

  /** Returns the texts that have been placed. */
  List<Text> texts() {
    return List.copyOf(texts);
  }

  /** Returns points on each line to a part, from its name; two lines for each name. */
  List<List<Rect>> leaders() {
    return List.copyOf(leaders);
  }

  private double pen(double size) {
    return Math.max(1, size / CAPITALS_PER_PEN);
  }

  private double halo() {
    return Math.max(1, capital / CAPITALS_PER_HALO);
  }

  /** Returns the rectangle of a text around the middle of its capitals. */
  Rect box(String text, double x, double y, double size) {
    double unit = size / StrokeFont.CAPITAL;
    double pad = halo() + .5 * pen(size);
    double half = .5 * StrokeFont.width(text, size) + pad;
    return new Rect(
        x - half,
        y + .5 * size - StrokeFont.ASCENT * unit - pad,
        x + half,
        y + .5 * size + StrokeFont.DESCENT * unit + pad);
  }

  /** Returns whether a label may be there: inside the picture, and where none is. */
  boolean isFree(Rect box) {
    return box.isInside(frame) && taken.stream().noneMatch(box::overlaps);
  }

  /** Keeps texts out of a rectangle. */
  void reserve(Rect box) {
    taken.add(box);
  }

  /**
   * Writes a text if there is room.
   *
   * @param x of its middle
   * @param y of the middle of its capitals
   * @param size height of capitals in pixels
   */
  boolean write(String text, double x, double y, double size, Tone tone) {
    Rect box = box(text, x, y, size);
    if (!isFree(box)) {
      return false;
    }
    reserve(box);
    texts.add(new Text(text, box));
    double left = x - .5 * StrokeFont.width(text, size);
    StrokeFont.add(strokes(tone, pen(size), halo()), text, left, y + .5 * size, size);
    return true;
  }

  /**
   * Returns a text, or its beginning and dots if it is too wide; empty if less than {@link
   * #LEAST_LETTERS} fit.
   */
  String shortened(String text, double size, double width) {
    int[] characters = text.codePoints().toArray();
    int least = Math.min(LEAST_LETTERS, characters.length);
    for (int count = characters.length; count >= least; count--) {
      String part = new String(characters, 0, count) + (count < characters.length ? DOTS : "");
      if (box(part, 0, 0, size).width() <= width) {
        return part;
      }
    }
    return "";
  }

  /**
   * Returns the strokes of lines to add to.
   *
   * @param share of the width of the strokes of texts
   */
  Strokes lines(Tone tone, double share) {
    return strokes(tone, share * pen(capital), halo());
  }

  /** Returns strokes that hide little of the picture. */
  Strokes fineLines() {
    return strokes(Tone.INK, Math.max(1, .6 * pen(capital)), .2 * halo());
  }

  private Strokes strokes(Tone tone, double width, double edge) {
    return strokes.computeIfAbsent(new Ink(tone, width, edge), ink -> new Strokes());
  }

  /** Returns whether a line between two points is in the picture, and crosses no label. */
  boolean isClear(double fromX, double fromY, double toX, double toY) {
    return points(fromX, fromY, toX, toY).stream().allMatch(this::isFree);
  }

  /** Returns whether a text may be there: where no label is, and no line to a part. */
  boolean isClear(Rect box) {
    return isFree(box) && leaders.stream().flatMap(List::stream).noneMatch(box::overlaps);
  }

  /** Draws a line from the name of a part. */
  void lead(double fromX, double fromY, double toX, double toY) {
    lines(Tone.INK, .8).add(fromX, fromY, toX, toY);
    leaders.add(points(fromX, fromY, toX, toY));
  }

  private List<Rect> points(double fromX, double fromY, double toX, double toY) {
    double distance = Math.max(Math.abs(toX - fromX), Math.abs(toY - fromY));
    int steps = 1 + (int) (4 * distance / capital);
    List<Rect> points = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double t = (double) i / steps;
      points.add(Rect.around(fromX + t * (toX - fromX), fromY + t * (toY - fromY), 0, 0));
    }
    return points;
  }

  /** Returns the highest and the lowest y of the room between labels in some columns. */
  double[] room(double left, double right) {
    double[] room = {margin(), frame.bottom() - margin()};
    for (Rect box : taken) {
      if (box.left() < right && box.right() > left) {
        if (box.top() + box.bottom() < frame.bottom()) {
          room[0] = Math.max(room[0], box.bottom());
        } else {
          room[1] = Math.min(room[1], box.top());
        }
      }
    }
    return room;
  }

  /** Draws everything: first the halos, so that no halo covers a label. */
  void draw(Easel easel, boolean isOnDark) {
    Rgb behind = isOnDark ? Rgb.BLACK : Rgb.WHITE;
    strokes.forEach(
        (ink, lines) -> easel.draw(lines, new Pen(behind, ink.width() + 2 * ink.edge())));
    strokes.forEach(
        (ink, lines) -> {
          Rgb color = isOnDark ? ink.tone().onDark : ink.tone().onBright;
          easel.draw(lines, new Pen(color, ink.width()));
        });
  }
}
