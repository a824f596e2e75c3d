package io.github.lumbre.stage.drawing;

import java.util.ArrayList;
import java.util.List;

/**
 * The shape of a character in the units of {@link StrokeFont}.
 *
 * @param width of the shape, from x = 0
 * @param strokes x and y of the points of each stroke, at least two points
 */
record Glyph(double width, List<double[]> strokes) {
  /** Collects strokes. Mutable. */
  static final class Builder {
    /** Segments of a curve between two points. */
    private static final int SEGMENTS = 8;

    private final List<double[]> strokes = new ArrayList<>();
    private final List<Double> points = new ArrayList<>();
    private double[] control = {};

    /** Adds a point {@code x,y} to the stroke, or a control point {@code ~x,y}. */
    void add(String word) {
      boolean isControl = word.startsWith("~");
      String[] parts = word.substring(isControl ? 1 : 0).split(",");
      double x = Double.parseDouble(parts[0]);
      double y = Double.parseDouble(parts[1]);
      if (isControl) {
        control = new double[] {x, y};
      } else if (control.length > 0) {
        addCurve(x, y);
        control = new double[0];
      } else {
        points.add(x);
        points.add(y);
      }
    }

    private void addCurve(double x, double y) {
      double fromX = points.get(points.size() - 2);
      double fromY = points.get(points.size() - 1);
      for (int i = 1; i <= SEGMENTS; i++) {
        double t = (double) i / SEGMENTS;
        points.add(bezier(fromX, control[0], x, t));
        points.add(bezier(fromY, control[1], y, t));
      }
    }

    private static double bezier(double from, double control, double to, double t) {
      double s = 1 - t;
      return s * s * from + 2 * s * t * control + t * t * to;
    }

    void endStroke() {
      if (!points.isEmpty()) {
        strokes.add(points.stream().mapToDouble(Double::doubleValue).toArray());
        points.clear();
      }
    }

    void addAll(Glyph other) {
      strokes.addAll(other.strokes);
    }

    Glyph glyph(double width) {
      endStroke();
      return new Glyph(width, List.copyOf(strokes));
    }
  }
}
