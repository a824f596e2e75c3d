package io.github.lumbre.lab.trade;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;

/**
 * A chart of points with intervals on two logarithmic axes, as SVG. It has the colors of the
 * surrounding style sheet, so that it follows the page's dark mode.
 */
final class LogChart {
  private static final int WIDTH = 460;
  private static final int PLOT_HEIGHT = 270;
  private static final int LEFT = 58;
  private static final int TOP = 34;
  private static final double RIGHT = WIDTH - 14.0;
  private static final double BOTTOM = TOP + (double) PLOT_HEIGHT;
  private static final int BELOW = 42;
  private static final int LEGEND_LINE = 18;
  private static final String MIDDLE = "text-anchor=\"middle\"";

  /** The longest name, in letters, that fits into a legend of three columns. */
  private static final int SHORT_NAME = 17;

  /** The number of series colors in the style sheet. */
  private static final int COLORS = 8;

  private final String title;
  private final String across;
  private final String up;
  private final List<Series> series;
  private final int legendColumns;
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
    x = LogAxis.over(all.stream().mapToDouble(Point::x), LEFT + 6.0, RIGHT - 6);
    y = LogAxis.over(all.stream().flatMapToDouble(LogChart::heights), BOTTOM - 6, TOP + 12.0);
  }

  private static DoubleStream heights(Point point) {
    // An interval may reach down to 0, which a logarithmic axis cannot show.
    return DoubleStream.of(point.y, point.high, Math.max(point.low, point.y / 3));
  }

  /** Returns the SVG for a page with a style sheet. */
  String svg() {
    lines.clear();
    int legend = (series.size() + legendColumns - 1) / legendColumns * LEGEND_LINE;
    add(
        "<svg viewBox=\"0 0 %d %d\" role=\"img\" font-family=\"system-ui,sans-serif\""
            + " font-size=\"12\" fill=\"var(--ink)\"><title>%s</title>",
        WIDTH, TOP + PLOT_HEIGHT + BELOW + legend, Html.escaped(title));
    axes();
    for (int i = 0; i < series.size(); i++) {
      draw(series.get(i), i);
      legend(series.get(i), i);
    }
    lines.add("</svg>");
    return String.join("\n", lines);
  }

  private void axes() {
    text(LEFT, 20, "font-size=\"14\"", title);
    for (LogAxis.Tick tick : x.ticks()) {
      line(tick.at(), TOP, tick.at(), BOTTOM, "var(--grid)", 1);
      text(tick.at(), BOTTOM + 16, MIDDLE, tick.text());
    }
    for (LogAxis.Tick tick : y.ticks()) {
      line(LEFT, tick.at(), RIGHT, tick.at(), "var(--grid)", 1);
      text(LEFT - 6, tick.at() + 4, "text-anchor=\"end\"", tick.text());
    }
    text((LEFT + RIGHT) / 2, BOTTOM + 34, MIDDLE, across);
    double middle = TOP + PLOT_HEIGHT / 2.0;
    text(13, middle, format(MIDDLE + " transform=\"rotate(-90 13 %.1f)\"", middle), up);
  }

  private void legend(Series s, int number) {
    double left = LEFT + number % legendColumns * (RIGHT - LEFT) / legendColumns;
    double base = BOTTOM + BELOW + LEGEND_LINE * (number / legendColumns) + 8;
    boolean isFaint = !s.points.isEmpty() && s.points.stream().allMatch(Point::isFaint);
    mark(left + 4, base - 4, number, shade(number, isFaint));
    text(left + 14, base, "", s.name);
  }

  private static String shade(int number, boolean isFaint) {
    return isFaint ? "var(--faint)" : "var(--s" + number % COLORS + ")";
  }

  private void draw(Series s, int number) {
    if (s.isJoined && s.points.size() > 1) {
      StringBuilder path = new StringBuilder();
      for (Point point : s.points) {
        path.append(path.length() == 0 ? "M" : "L");
        path.append(format("%.1f %.1f", x.at(point.x), y.at(point.y)));
      }
      add(
          "<path d=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" stroke-opacity=\".6\"/>",
          path, shade(number, false));
    }
    for (Point point : s.points) {
      double px = x.at(point.x);
      String shade = shade(number, point.isFaint);
      line(px, y.at(point.low), px, y.at(point.high), shade, 1.5);
      mark(px, y.at(point.y), number, shade);
      String style = format("class=\"point\" %s fill=\"%s\" font-size=\"11\"", MIDDLE, shade);
      text(px, y.at(point.high) - 5, style, point.label);
    }
  }

  /** Draws a marker whose shape identifies the series without color. */
  private void mark(double px, double py, int number, String color) {
    switch (number % 3) {
      case 0 -> add("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\"/>", px, py, color);
      case 1 ->
          add(
              "<rect x=\"%.1f\" y=\"%.1f\" width=\"6.4\" height=\"6.4\" fill=\"%s\"/>",
              px - 3.2, py - 3.2, color);
      default -> add("<path d=\"M%.1f %.1fl4 7h-8z\" fill=\"%s\"/>", px, py - 4.2, color);
    }
  }

  private void line(double x1, double y1, double x2, double y2, String color, double width) {
    add(
        "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"%.1f\"/>",
        x1, y1, x2, y2, color, width);
  }

  private void text(double px, double py, String attributes, String content) {
    if (!content.isEmpty()) {
      add("<text x=\"%.1f\" y=\"%.1f\" %s>%s</text>", px, py, attributes, Html.escaped(content));
    }
  }

  private void add(String form, Object... values) {
    lines.add(format(form, values));
  }

  private static String format(String form, Object... values) {
    return String.format(Locale.ROOT, form, values);
  }
}
