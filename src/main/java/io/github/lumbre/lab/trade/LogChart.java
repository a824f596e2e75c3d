package io.github.lumbre.lab.trade;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;

/**
 * A chart of points with intervals on two logarithmic axes, as SVG. Its colors are those of the
 * surrounding style sheet, so that it follows the page's dark mode.
 */
final class LogChart {
  private static final int WIDTH = 460;
  private static final int PLOT_HEIGHT = 270;
  private static final int LEFT = 58;
  private static final int RIGHT = 14;
  private static final int TOP = 34;
  private static final int BELOW = 42;
  private static final int LEGEND_LINE = 18;

  /** The longest name, in letters, that fits into a legend of three columns. */
  private static final int SHORT_NAME = 17;

  /** The number of series colors in the style sheet. */
  private static final int COLORS = 8;

  private final String title;
  private final String across;
  private final String up;
  private final List<Series> series;
  private final int legendColumns;
  private final int height;
  private final LogAxis x;
  private final LogAxis y;
  private final List<String> lines = new ArrayList<>();

  /**
   * A data point.
   *
   * @param low lower end of the interval of y; at most 0 if it leaves the chart
   * @param high upper end of the interval of y
   * @param label label above the point; may be empty
   * @param isFaint whether another point dominates this one
   */
  record Point(double x, double y, double low, double high, String label, boolean isFaint) {}

  /**
   * A series of points.
   *
   * @param isJoined whether a line connects consecutive points
   */
  record Series(String name, List<Point> points, boolean isJoined) {}

  /**
   * @param title title of the chart; may be empty
   * @param across label of the horizontal axis
   * @param up label of the vertical axis
   */
  LogChart(String title, String across, String up, List<Series> series) {
    this.title = title;
    this.across = across;
    this.up = up;
    this.series = List.copyOf(series);
    List<Point> all = series.stream().flatMap(s -> s.points.stream()).toList();
    legendColumns = series.stream().allMatch(s -> s.name.length() <= SHORT_NAME) ? 3 : 2;
    int legend = (series.size() + legendColumns - 1) / legendColumns * LEGEND_LINE;
    height = TOP + PLOT_HEIGHT + BELOW + legend;
    x = LogAxis.over(all.stream().mapToDouble(Point::x), LEFT + 6.0, WIDTH - RIGHT - 6.0);
    y = LogAxis.over(all.stream().flatMapToDouble(LogChart::heights), bottom() - 6.0, TOP + 12.0);
  }

  private static DoubleStream heights(Point point) {
    // An interval may reach down to 0, which a logarithmic axis cannot show.
    return DoubleStream.of(point.y, point.high, Math.max(point.low, point.y / 3));
  }

  private static double bottom() {
    return TOP + (double) PLOT_HEIGHT;
  }

  /** Returns the SVG for a page with a style sheet. */
  String svg() {
    lines.clear();
    lines.add(
        format(
            "<svg viewBox=\"0 0 %d %d\" role=\"img\""
                + " font-family=\"system-ui,sans-serif\"><title>%s</title>",
            WIDTH, height, Html.escaped(title.isEmpty() ? up + ", " + across : title)));
    grid();
    for (int i = 0; i < series.size(); i++) {
      draw(series.get(i), i);
      legend(series.get(i), i);
    }
    lines.add("</svg>");
    return String.join("\n", lines);
  }

  private static String color(int number) {
    return "var(--s" + number % COLORS + ")";
  }

  private void grid() {
    text(LEFT, 20, "start", "var(--ink)", 14, title);
    for (LogAxis.Tick tick : x.ticks()) {
      line(tick.at(), TOP, tick.at(), bottom(), "var(--grid)", 1);
      text(tick.at(), bottom() + 16, "middle", "var(--ink)", 12, tick.text());
    }
    for (LogAxis.Tick tick : y.ticks()) {
      line(LEFT, tick.at(), WIDTH - (double) RIGHT, tick.at(), "var(--grid)", 1);
      text(LEFT - 6.0, tick.at() + 4, "end", "var(--ink)", 12, tick.text());
    }
    text((LEFT + WIDTH - RIGHT) / 2.0, bottom() + 34, "middle", "var(--ink)", 12, across);
    double middle = TOP + PLOT_HEIGHT / 2.0;
    lines.add(
        format(
            "<text x=\"13\" y=\"%.1f\" text-anchor=\"middle\" fill=\"var(--ink)\" font-size=\"12\""
                + " transform=\"rotate(-90 13 %.1f)\">%s</text>",
            middle, middle, Html.escaped(up)));
  }

  private void legend(Series s, int number) {
    double left = LEFT + number % legendColumns * (WIDTH - LEFT - RIGHT) / (double) legendColumns;
    double at = bottom() + BELOW + LEGEND_LINE * (number / legendColumns) + 8.0;
    boolean isFaint = !s.points.isEmpty() && s.points.stream().allMatch(Point::isFaint);
    lines.add(mark(left + 4, at - 4, number, isFaint ? "var(--faint)" : color(number)));
    text(left + 14, at, "start", "var(--ink)", 12, s.name);
  }

  private void draw(Series s, int number) {
    if (s.isJoined && s.points.size() > 1) {
      StringBuilder path = new StringBuilder();
      for (Point point : s.points) {
        path.append(path.length() == 0 ? "M" : "L");
        path.append(format("%.1f %.1f", x.at(point.x), y.at(point.y)));
      }
      lines.add(
          "<path d=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" stroke-opacity=\".6\"/>"
              .formatted(path, color(number)));
    }
    for (Point point : s.points) {
      double px = x.at(point.x);
      String shade = point.isFaint ? "var(--faint)" : color(number);
      line(px, y.at(point.low), px, y.at(point.high), shade, 1.5);
      lines.add(mark(px, y.at(point.y), number, shade));
      label(px, y.at(point.high) - 5, shade, point.label);
    }
  }

  /** Returns a marker whose shape identifies the series without color. */
  private static String mark(double px, double py, int number, String color) {
    return switch (number % 3) {
      case 0 -> format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\"/>", px, py, color);
      case 1 ->
          format(
              "<rect x=\"%.1f\" y=\"%.1f\" width=\"6.4\" height=\"6.4\" fill=\"%s\"/>",
              px - 3.2, py - 3.2, color);
      default -> format("<path d=\"M%.1f %.1fl4 7h-8z\" fill=\"%s\"/>", px, py - 4.2, color);
    };
  }

  private void line(double x1, double y1, double x2, double y2, String color, double width) {
    lines.add(
        format(
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\""
                + " stroke-width=\"%.1f\"/>",
            x1, y1, x2, y2, color, width));
  }

  private void text(double left, double base, String anchor, String color, int size, String text) {
    if (!text.isEmpty()) {
      lines.add(
          format(
              "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\" font-size=\"%d\">%s"
                  + "</text>",
              left, base, anchor, color, size, Html.escaped(text)));
    }
  }

  private void label(double middle, double base, String color, String text) {
    if (!text.isEmpty()) {
      lines.add(
          format(
              "<text class=\"point\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" fill=\"%s\""
                  + " font-size=\"11\">%s</text>",
              middle, base, color, Html.escaped(text)));
    }
  }

  private static String format(String form, Object... values) {
    return String.format(Locale.ROOT, form, values);
  }
}
