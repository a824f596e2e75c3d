package io.github.lumbre.camera.internal;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.Optional;

/**
 * The map from points to the pixels of a perspective or parallel camera, through the center of its
 * lens. Immutable.
 *
 * <p>It is a 4×4 matrix M, acting on column vectors: with (X, Y, D, W) = M (x, y, z, 1), the point
 * (x, y, z) is at the pixel position (X / W, Y / W) and at the depth D. Pixel positions start at
 * the left upper corner of the picture, with y down, so that the center of the first pixel is at
 * (0.5, 0.5). The depth is the distance from the camera's plane along its view, not along the ray.
 * W is the depth in perspective, where points of depth 0 and below have no image, and 1 in parallel
 * projection.
 */
public final class Projection {
  private static final double NEAR = 1e-9;

  /** The depth of a point off both axes, to see whether a camera is linear. */
  private static final double PROBE_DEPTH = 3;

  private final List<Row> rows;

  private record Row(Vec3 factors, double constant) {
    double times(Vec3 point) {
      return factors.dot(point) + constant;
    }

    Row scaled(double factor) {
      return new Row(factors.times(factor), factor * constant);
    }

    Row plus(double factor, Row other) {
      return new Row(factors.plus(factor, other.factors), constant + factor * other.constant);
    }

    Row of(Transform toSpace) {
      Vec3 origin = toSpace.point(Vec3.ZERO);
      return new Row(
          new Vec3(
              factors.dot(toSpace.vector(Vec3.X)),
              factors.dot(toSpace.vector(Vec3.Y)),
              factors.dot(toSpace.vector(Vec3.Z))),
          times(origin));
    }

    List<Double> values() {
      // The sum with 0 replaces -0 by 0.
      return List.of(factors.x() + 0., factors.y() + 0., factors.z() + 0., constant + 0.);
    }
  }

  private Projection(Row x, Row y, Row depth, Row w) {
    rows = List.of(x, y, depth, w);
  }

  /**
   * Returns the map from world space to the pixels of a camera; empty if it bends straight lines,
   * as panoramas do.
   *
   * @param width of the full frame in pixels, whose aspect ratio is the camera's
   * @param height of the full frame in pixels
   */
  public static Optional<Projection> of(Camera camera, int width, int height) {
    Camera local = camera.movedTo(Vec3.ZERO, Frame.WORLD);
    double right = slope(local, Vec3.X);
    double up = slope(local, Vec3.Y);
    Row one = new Row(Vec3.ZERO, 1);
    Row depth = row(camera, camera.axes().normal());
    Vec3 probe = new Vec3(.4 / right, .3 / up, PROBE_DEPTH);
    Optional<Point2> found = local.project(probe);
    for (Row w : List.of(depth, one)) {
      double distance = w == one ? 1 : PROBE_DEPTH;
      Point2 expected = new Point2(.5 + .4 / distance, .5 + .3 / distance);
      if (found.filter(film -> isNear(film, expected)).isPresent()) {
        Row x = row(camera, camera.axes().tangent()).scaled(right * width).plus(.5 * width, w);
        Row y = row(camera, camera.axes().bitangent()).scaled(up * height).plus(.5 * height, w);
        return Optional.of(new Projection(x, y, depth, w));
      }
    }
    return Optional.empty();
  }

  /**
   * Returns the height of what a perspective or parallel camera has in its frame at depth 1, in the
   * unit of world space.
   */
  public static double frameHeight(Camera camera) {
    return 1 / Math.abs(slope(camera.movedTo(Vec3.ZERO, Frame.WORLD), Vec3.Y));
  }

  /** Returns the coordinate of points along an axis of a camera. */
  private static Row row(Camera camera, Vec3 axis) {
    return new Row(axis, -axis.dot(camera.position()));
  }

  /** Returns by how much a film coordinate changes with a step along an axis, at depth 1. */
  private static double slope(Camera local, Vec3 axis) {
    double step = 1;
    double change = change(local, axis, step);
    // Near the middle of the film, the difference would lose digits.
    while (Math.abs(change) < .25 && step < 0x1p1000) {
      step *= 2;
      change = change(local, axis, step);
    }
    return change / step;
  }

  private static double change(Camera local, Vec3 axis, double step) {
    Point2 film = local.project(Vec3.Z.plus(step, axis)).orElse(new Point2(1, 1));
    return axis.dot(new Vec3(film.x() - .5, film.y() - .5, 0));
  }

  private static boolean isNear(Point2 one, Point2 other) {
    return Math.abs(one.x() - other.x()) + Math.abs(one.y() - other.y()) < NEAR;
  }

  /**
   * Returns the map from another space to the same pixels.
   *
   * @param toSpace from the other space to the space of this map
   */
  public Projection from(Transform toSpace) {
    return new Projection(
        rows.get(0).of(toSpace),
        rows.get(1).of(toSpace),
        rows.get(2).of(toSpace),
        rows.get(3).of(toSpace));
  }

  /** Returns the map to the pixels of a part of the frame that starts at a pixel. */
  public Projection cropped(int left, int top) {
    Row w = rows.get(3);
    return new Projection(
        rows.get(0).plus(-left, w), rows.get(1).plus(-top, w), rows.get(2), rows.get(3));
  }

  /**
   * Returns the pixel position of a point as x and y, and its depth as z. In perspective, x and y
   * mean nothing if the depth is not positive.
   */
  public Vec3 pixel(Vec3 point) {
    double w = rows.get(3).times(point);
    return new Vec3(
        rows.get(0).times(point) / w, rows.get(1).times(point) / w, rows.get(2).times(point));
  }

  /** Returns whether the projection is parallel, so that the size of things has no perspective. */
  public boolean isParallel() {
    return rows.get(3).factors.maxAbs() == 0;
  }

  /** Returns the four rows of the matrix, of four numbers each. */
  public List<List<Double>> matrix() {
    return rows.stream().map(Row::values).toList();
  }
}
