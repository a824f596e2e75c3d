package io.github.lumbre.cli.view;

import java.util.ArrayList;
import java.util.List;

/**
 * The errors of a picture over time, at a bounded number of moments. Once there are too many, the
 * point whose neighbors are nearest on a logarithmic time axis is dropped, so that the rest shows
 * the first second as well as the last hour. Mutable; callers synchronize.
 */
final class ErrorHistory {
  /** The largest number of points: as many as a chart of the page has pixels. */
  static final int MOST = 256;

  private final List<ErrorPoint> points = new ArrayList<>();

  /** Adds a point that is later than all others. */
  void add(ErrorPoint point) {
    points.add(point);
    if (points.size() > MOST) {
      points.remove(mostCrowded());
    }
  }

  /** Returns the index of the point, neither first nor last, that is missed least. */
  private int mostCrowded() {
    int found = 1;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 1; i < points.size() - 1; i++) {
      // The point before may be at zero seconds.
      double before = Math.max(1e-9, points.get(i - 1).seconds());
      double ratio = points.get(i + 1).seconds() / before;
      if (ratio < least) {
        least = ratio;
        found = i;
      }
    }
    return found;
  }

  void clear() {
    points.clear();
  }

  /** Returns a copy, from the first point to the last. */
  List<ErrorPoint> points() {
    return List.copyOf(points);
  }
}
