package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import java.util.Optional;

/**
 * How the points that a frame shows look in another frame. A point is followed by the exact poses
 * of its surface and of the cameras, and compared with what the other frame shows around its place:
 * the same part of the same primitive, at the same depth and with the same normal. Mutable while it
 * is computed.
 */
final class FrameTracks {
  /** The least product of the normals of a point and of a pixel that shows it. */
  private static final double LEAST_NORMAL = .7;

  /** How far a pixel's point may be from the plane of another, for each length along it. */
  private static final double STEEPEST = .5;

  /** The same, for each length from the camera. */
  private static final double ROUNDING = 1e-4;

  /** The least share of the pixels around a place that show its point. */
  private static final double LEAST_SHARE = .5;

  private final SeenFrame from;
  private final SeenFrame to;
  private final double[] places;
  private final int[] numbers;
  private final int width;
  private final int height;

  /** The differences of divided light from that of the frame, three values for each pixel. */
  final float[] differences;

  /** The sums of the variances in both frames. */
  final float[] variances;

  /** 1 for pixels whose point is visible in the other frame, otherwise 0. */
  final float[] isFollowed;

  private FrameTracks(SeenFrame from, double[] places, SeenFrame to) {
    this.from = from;
    this.places = places;
    this.to = to;
    numbers = from.surfaces.numbersIn(to.surfaces);
    width = from.image.width();
    height = from.image.height();
    differences = new float[3 * width * height];
    variances = new float[width * height];
    isFollowed = new float[width * height];
  }

  /**
   * Returns where the camera of a frame sees the point of each pixel, as two film coordinates for
   * each pixel; NaN where there is none.
   */
  static double[] places(SeenFrame frame) {
    int pixels = frame.image.width() * frame.image.height();
    double[] places = new double[2 * pixels];
    Arrays.fill(places, Double.NaN);
    for (int i = 0; i < pixels; i++) {
      if (frame.primitive(i) >= 0) {
        Optional<Point2> place =
            frame.surfaces.project(frame.point(i, frame.surfaces, frame.primitive(i)));
        places[2 * i] = place.isPresent() ? place.get().x() : Double.NaN;
        places[2 * i + 1] = place.isPresent() ? place.get().y() : Double.NaN;
      }
    }
    return places;
  }

  /**
   * Follows all points of a frame to another frame of the same size.
   *
   * @param places of the frame
   * @throws InterruptedException if the calling thread is interrupted
   */
  static FrameTracks of(SeenFrame from, double[] places, SeenFrame to, int threads)
      throws InterruptedException {
    FrameTracks tracks = new FrameTracks(from, places, to);
    Rows.compute(tracks.height, threads, () -> tracks.new Follower()::follow);
    return tracks;
  }

  /** Follows the points of rows. Mutable; each thread has one. */
  private final class Follower {
    private final double[] light = new double[3];
    private double variance;
    private double share;
    private int triangle;

    void follow(int y) {
      for (int x = 0; x < width; x++) {
        int pixel = y * width + x;
        int primitive = from.primitive(pixel);
        if (primitive >= 0 && numbers[primitive] >= 0) {
          follow(x, y, pixel, primitive);
        }
      }
    }

    private void follow(int x, int y, int pixel, int primitive) {
      Vec3 there = from.point(pixel, to.surfaces, numbers[primitive]);
      Optional<Point2> end = to.surfaces.project(there);
      if (end.isEmpty()) {
        return;
      }
      // Differences cancel errors of rounding: what stands still does not move at all.
      double px = x + (end.get().x() - places[2 * pixel]) * from.settings.width();
      double py = y + (end.get().y() - places[2 * pixel + 1]) * from.settings.height();
      if (!(px > -1 && py > -1 && px < width && py < height)) {
        return;
      }
      clear();
      triangle = from.triangle(pixel);
      Vec3 across = to.surfaces.across(numbers[primitive], triangle);
      addAround(px, py, numbers[primitive], there, across);
      if (share >= LEAST_SHARE) {
        store(pixel);
      }
    }

    private void clear() {
      light[0] = 0;
      light[1] = 0;
      light[2] = 0;
      variance = 0;
      share = 0;
    }

    /** Adds the pixels around a place that show a point, by bilinear interpolation. */
    private void addAround(double px, double py, int number, Vec3 point, Vec3 across) {
      int left = (int) Math.floor(px);
      int top = (int) Math.floor(py);
      double right = px - left;
      double down = py - top;
      add(left, top, (1 - right) * (1 - down), number, point, across);
      add(left + 1, top, right * (1 - down), number, point, across);
      add(left, top + 1, (1 - right) * down, number, point, across);
      add(left + 1, top + 1, right * down, number, point, across);
    }

    private void add(int x, int y, double weight, int number, Vec3 point, Vec3 across) {
      if (!(weight > 0) || x < 0 || y < 0 || x >= width || y >= height) {
        return;
      }
      int pixel = y * width + x;
      if (to.primitive(pixel) != number
          || to.triangle(pixel) != triangle && !shows(pixel, number, point, across)) {
        return;
      }
      share += weight;
      variance += weight * to.variances[pixel];
      for (int c = 0; c < 3; c++) {
        light[c] += weight * to.divided(pixel, c);
      }
    }

    /** Returns whether the surface of a pixel continues the one of a point. */
    private boolean shows(int pixel, int number, Vec3 point, Vec3 across) {
      Vec3 normal = to.surfaces.across(number, to.triangle(pixel));
      double lengths = Math.sqrt(normal.dot(normal) * across.dot(across));
      if (!(normal.dot(across) >= LEAST_NORMAL * lengths)) {
        return false;
      }
      Vec3 way = point.minus(to.point(pixel, to.surfaces, number));
      double off = Math.abs(way.dot(normal)) / normal.length();
      double distance = point.minus(to.surfaces.eye()).length();
      return off <= STEEPEST * way.length() + ROUNDING * distance;
    }

    private void store(int pixel) {
      isFollowed[pixel] = 1;
      variances[pixel] = (float) (from.variances[pixel] + variance / share);
      for (int c = 0; c < 3; c++) {
        differences[3 * pixel + c] = (float) (light[c] / share - from.divided(pixel, c));
      }
    }
  }
}
