package io.github.lumbre.measure;

import io.github.lumbre.math.Elementary;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A chart of points with intervals on two logarithmic axes, as inline SVG. */
final class LogChart {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 400;
  private static final int LEFT = 70;
  private static final int RIGHT = 150;
  private static final int TOP = 16;
  private static final int BOTTOM = 48;
  private static final String[] COLOURS = {
    "#1b6ca8", "#c8553d", "#3a7d44", "#8e5ea2", "#b8860b", "#444444", "#2a9d8f", "#d1495b"
  };

  private final String across;
  private final String up;
  private final List<Series> series;
  private Axis x;
  private Axis y;

  /**
   * A point.
   *
   * @param low end of the interval of y; at most 0 if it reaches out of the chart
   * @param isFaint whether another point is better in every way
   */
  record Point(double x, double y, double low, double high, String label, boolean isFaint) {}

  /** Points that belong together, joined by a line. */
  record Series(String name, List<Point> points) {}

  /** A logarithmic axis from one power of ten to another, and where it lies. */
  private record Axis(int first, int last, double from, double to) {
    static Axis over(double[] values, double from, double to) {
      double min = Double.POSITIVE_INFINITY;
      double max = 0;
      for (double value : values) {
        if (value > 0) {
          min = Math.min(min, value);
          max = Math.max(max, value);
        }
      }
      if (max == 0) {
        return new Axis(-1, 0, from, to);
      }
      int first = (int) Math.floor(log10(min));
      int last = (int) Math.ceil(log10(max));
      return new Axis(first, Math.max(last, first + 1), from, to);
    }

    double at(double value) {
      double place = value <= 0 ? 0 : (log10(value) - first) / (last - first);
      return from + Math.max(0, Math.min(place, 1)) * (to - from);
    }
  }

  /**
   * @param across what the horizontal axis is
   * @param up what the vertical axis is
   */
  LogChart(String across, String up, List<Series> series) {
    this.across = across;
    this.up = up;
    this.series = List.copyOf(series);
  }

  private static double log10(double value) {
    return Elementary.log(value) / Elementary.log(10);
  }

  /** Returns the drawing. */
  String svg() {
    List<Point> all = series.stream().flatMap(s -> s.points.stream()).toList();
    x = Axis.over(all.stream().mapToDouble(Point::x).toArray(), LEFT, WIDTH - (double) RIGHT);
    y = Axis.over(all.stream().mapToDouble(Point::y).toArray(), HEIGHT - (double) BOTTOM, TOP);
    List<String> lines = new ArrayList<>();
    lines.add(
        "<svg viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" role=\"img\">"
            .formatted(WIDTH, HEIGHT, WIDTH, HEIGHT));
    grid(lines);
    for (int i = 0; i < series.size(); i++) {
      draw(series.get(i), COLOURS[i % COLOURS.length], i, lines);
    }
    lines.add("</svg>");
    return String.join("\n", lines);
  }

  private void grid(List<String> lines) {
    for (int decade = x.first; decade <= x.last; decade++) {
      double at = x.at(Elementary.pow(10, decade));
      line(at, TOP, at, HEIGHT - (double) BOTTOM, "#ddd", 1, lines);
      text(at, HEIGHT - BOTTOM + 18.0, "middle", "#333", number(decade), lines);
    }
    for (int decade = y.first; decade <= y.last; decade++) {
      double at = y.at(Elementary.pow(10, decade));
      line(LEFT, at, WIDTH - (double) RIGHT, at, "#ddd", 1, lines);
      text(LEFT - 6.0, at + 4, "end", "#333", number(decade), lines);
    }
    text((LEFT + WIDTH - RIGHT) / 2.0, HEIGHT - 8.0, "middle", "#111", across, lines);
    double middle = (TOP + HEIGHT - BOTTOM) / 2.0;
    lines.add(
        format(
            "<text x=\"14\" y=\"%.1f\" text-anchor=\"middle\" fill=\"#111\" font-size=\"12\""
                + " transform=\"rotate(-90 14 %.1f)\">%s</text>",
            middle, middle, escaped(up)));
  }

  private static String number(int decade) {
    return decade >= -3 && decade <= 3
        ? String.format(Locale.ROOT, "%." + Math.max(0, -decade) + "f", Elementary.pow(10, decade))
        : "1e" + decade;
  }

  private void draw(Series s, String colour, int number, List<String> lines) {
    StringBuilder path = new StringBuilder();
    for (Point point : s.points) {
      path.append(path.length() == 0 ? "M" : "L");
      path.append(format("%.1f %.1f", x.at(point.x), y.at(point.y)));
    }
    lines.add(
        "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-opacity=\".5\"/>");
    for (Point point : s.points) {
      double px = x.at(point.x);
      String shade = point.isFaint ? "#aaa" : colour;
      line(px, y.at(point.low), px, y.at(point.high), shade, 2, lines);
      lines.add(
          format(
              "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>", px, y.at(point.y), shade));
      text(px + 6, y.at(point.y) - 6, "start", shade, point.label, lines);
    }
    text(WIDTH - RIGHT + 12.0, TOP + 14.0 + 18 * number, "start", colour, s.name, lines);
  }

  private static void line(
      double x1, double y1, double x2, double y2, String colour, int width, List<String> lines) {
    lines.add(
        format(
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\""
                + " stroke-width=\"%d\"/>",
            x1, y1, x2, y2, colour, width));
  }

  private static void text(
      double x, double y, String anchor, String colour, String text, List<String> lines) {
    lines.add(
        format(
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\" font-size=\"12\">%s</text>",
            x, y, anchor, colour, escaped(text)));
  }

  private static String format(String form, Object... values) {
    return String.format(Locale.ROOT, form, values);
  }

  /** Returns a text as HTML and SVG can hold it. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
