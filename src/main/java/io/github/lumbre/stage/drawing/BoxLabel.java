package io.github.lumbre.stage.drawing;

import io.github.lumbre.base.text.Quantities;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.stage.drawing.LabelSheet.Tone;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** The box around a model, and its dimensions beside the edges of its outline. Stateless. */
final class BoxLabel {
  private static final int AXES = 3;

  /** Shorter edges in the picture have no dimension, in capitals. */
  private static final double SHORTEST = 1.5;

  /** The least distance of a dimension line from its edge, in capitals. */
  private static final double OFFSET = 2.2;

  /** Where along its edge the text of a dimension may be, the best place first. */
  private static final List<Double> PLACES = List.of(.5, .38, .62, .26, .74);

  /** A face with a smaller area in the picture, in pixels, is seen edge-on. */
  private static final double EDGE_ON = .5;

  private BoxLabel() {}

  /** An edge in the picture, and the unit vector across it that points away from the box. */
  private record Edge(Vec3 from, Vec3 to, double outX, double outY) {
    double length() {
      double x = to.x() - from.x();
      double y = to.y() - from.y();
      return Math.sqrt(x * x + y * y);
    }

    double alongX() {
      return (to.x() - from.x()) / length();
    }

    double alongY() {
      return (to.y() - from.y()) / length();
    }

    /** Steep edges have their dimensions at the right, others below. */
    double preference() {
      boolean isSteep = Math.abs(alongY()) > Math.abs(alongX());
      return isSteep ? from.x() + to.x() : from.y() + to.y();
    }
  }

  /** Draws the twelve edges. */
  static boolean drawEdges(LabelSheet sheet, LabeledModel model) {
    if (!model.isInFront()) {
      return false;
    }
    List<Vec3> corners = model.corners();
    Strokes lines = sheet.fineLines();
    for (int corner = 0; corner < corners.size(); corner++) {
      for (int axis = 0; axis < AXES; axis++) {
        if ((corner >> axis & 1) == 0) {
          Vec3 from = corners.get(corner);
          Vec3 to = corners.get(corner | 1 << axis);
          lines.add(from.x(), from.y(), to.x(), to.y());
        }
      }
    }
    return true;
  }

  /** Draws the dimensions; returns whether there was room for all whose edges can be seen. */
  static boolean drawSizes(LabelSheet sheet, LabeledModel model) {
    if (!model.isInFront()) {
      return false;
    }
    boolean isComplete = true;
    for (int axis = 0; axis < AXES; axis++) {
      double size = model.max().get(axis) - model.min().get(axis);
      String text = Quantities.text(size, model.unit());
      List<Edge> edges = outline(model.corners(), axis, SHORTEST * sheet.capital());
      isComplete &= edges.isEmpty() || edges.stream().anyMatch(e -> drawSize(sheet, e, text));
    }
    return isComplete;
  }

  /** Returns the edges along an axis that are on the outline of the box, the best first. */
  private static List<Edge> outline(List<Vec3> corners, int axis, double shortest) {
    Vec3 middle = Vec3.ZERO;
    for (Vec3 corner : corners) {
      middle = middle.plus(1. / corners.size(), corner);
    }
    List<Edge> edges = new ArrayList<>();
    int second = (axis + 1) % AXES;
    int third = (axis + 2) % AXES;
    for (int sides = 0; sides < 4; sides++) {
      int corner = (sides & 1) << second | (sides >> 1) << third;
      if (isFront(corners, second, corner) != isFront(corners, third, corner)) {
        Edge edge = edge(corners.get(corner), corners.get(corner | 1 << axis), middle);
        if (edge.length() >= shortest) {
          edges.add(edge);
        }
      }
    }
    edges.sort(Comparator.comparingDouble(edge -> -edge.preference()));
    return edges;
  }

  /** Returns whether the face across an axis on the side of a corner faces the viewer. */
  private static boolean isFront(List<Vec3> corners, int axis, int corner) {
    int side = corner & 1 << axis;
    int b = 1 << (axis + 1) % AXES;
    int c = 1 << (axis + 2) % AXES;
    int[] around = {side, side | b, side | b | c, side | c};
    double area = 0;
    for (int i = 0; i < around.length; i++) {
      Vec3 p = corners.get(around[i]);
      Vec3 q = corners.get(around[(i + 1) % around.length]);
      area += .5 * (p.x() * q.y() - q.x() * p.y());
    }
    // Counterclockwise from outside on the side of max; y points down in the picture.
    return (side == 0 ? area : -area) > EDGE_ON;
  }

  private static Edge edge(Vec3 from, Vec3 to, Vec3 middle) {
    double x = to.x() - from.x();
    double y = to.y() - from.y();
    double length = Math.sqrt(x * x + y * y);
    Vec3 toEdge = from.times(.5).plus(.5, to).minus(middle);
    double side = toEdge.x() * y - toEdge.y() * x < 0 ? -1 : 1;
    return new Edge(from, to, side * y / length, -side * x / length);
  }

  /** Draws a dimension with its text at the first place along the edge that is free. */
  private static boolean drawSize(LabelSheet sheet, Edge edge, String text) {
    return PLACES.stream().anyMatch(place -> drawSize(sheet, edge, text, place));
  }

  private static boolean drawSize(LabelSheet sheet, Edge edge, String text, double place) {
    double capital = sheet.capital();
    Rect box = sheet.box(text, 0, 0, capital);
    double width = .5 * box.width();
    double height = .5 * box.height();
    double across = Math.abs(edge.outX) * width + Math.abs(edge.outY) * height;
    // Half of the gap that the text leaves in the line.
    double gap =
        Math.min(width / Math.abs(edge.alongX()), height / Math.abs(edge.alongY())) + .3 * capital;
    double start = place * edge.length() - gap;
    double end = (1 - place) * edge.length() - gap;
    boolean isInLine = Math.min(start, end) >= 1.5 * capital;
    double offset = isInLine ? Math.max(OFFSET * capital, across + .7 * capital) : OFFSET * capital;
    double textOffset = isInLine ? offset : offset + across + .5 * capital;
    double[] from = moved(edge, edge.from, offset);
    double[] to = moved(edge, edge.to, offset);
    double[] middle = moved(edge, edge.from.plus(place, edge.to.minus(edge.from)), textOffset);
    if (!sheet.isClear(from[0], from[1], to[0], to[1])
        || !sheet.isClear(sheet.box(text, middle[0], middle[1], capital))
        || !sheet.write(text, middle[0], middle[1], capital, Tone.INK)) {
      return false;
    }
    Strokes lines = sheet.lines(Tone.INK, .8);
    double half = .5 * edge.length();
    arrow(lines, from, edge.alongX(), edge.alongY(), isInLine ? start : half, capital);
    arrow(lines, to, -edge.alongX(), -edge.alongY(), isInLine ? end : half, capital);
    for (Vec3 corner : List.of(edge.from, edge.to)) {
      double[] near = moved(edge, corner, .4 * capital);
      double[] far = moved(edge, corner, offset + .4 * capital);
      lines.add(near[0], near[1], far[0], far[1]);
    }
    return true;
  }

  private static double[] moved(Edge edge, Vec3 point, double offset) {
    return new double[] {point.x() + offset * edge.outX, point.y() + offset * edge.outY};
  }

  /** Draws a line with an arrow at its start. */
  private static void arrow(
      Strokes lines, double[] tip, double x, double y, double length, double capital) {
    double head = Math.min(.9 * capital, length);
    double side = .3 * head;
    lines.add(tip[0], tip[1], tip[0] + length * x, tip[1] + length * y);
    lines.add(tip[0], tip[1], tip[0] + head * x - side * y, tip[1] + head * y + side * x);
    lines.add(tip[0], tip[1], tip[0] + head * x + side * y, tip[1] + head * y - side * x);
  }
}
