package io.github.lumbre.integrator;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.scene.Scene;
import java.util.Arrays;

/**
 * What objects in a box block of the sky above the ground on which the box stands: at each point,
 * the part of short rays upwards that are blocked, the less the farther away the object is. It is
 * computed at the corners of a grid where a picture first needs it, and smooth between them, so
 * that it has no grain. Threads may share it; all of them compute the same numbers.
 */
final class ContactShadow {
  /** The distance from which on nothing casts a shadow, divided by the radius of the box. */
  private static final double REACH = .5;

  /** Corners of the grid per radius of the box. */
  private static final int CORNERS = 16;

  /** Rays of a corner. */
  private static final int RAYS = 64;

  /** How far the ground is below the box, divided by its radius, so that it touches no surface. */
  private static final double GAP = 1e-5;

  /** Corners around a point that count, along an axis. */
  private static final int SPAN = 4;

  /** Steps between the coordinates of points of an even sequence in three dimensions. */
  private static final double[] STEPS = {.8191725133961645, .6710436067037893, .5497004779019703};

  private final Scene scene;
  private final double reach;
  private final double step;
  private final double ground;
  private final double left;
  private final double back;
  private final int columns;
  private final int rows;

  /** By row and column; NaN if not yet computed. */
  private final float[] corners;

  private final Vec3[] directions = new Vec3[RAYS];
  private final double[] lengths = new double[RAYS];

  /**
   * @param box finite, of a radius above 0; y points up
   */
  ContactShadow(Scene scene, Bounds3 box) {
    this.scene = scene;
    reach = REACH * box.radius();
    step = box.radius() / CORNERS;
    ground = box.min().y() - GAP * box.radius();
    left = box.min().x() - reach;
    back = box.min().z() - reach;
    columns = 1 + (int) Math.ceil((box.max().x() + reach - left) / step);
    rows = 1 + (int) Math.ceil((box.max().z() + reach - back) / step);
    corners = new float[rows * columns];
    Arrays.fill(corners, Float.NaN);
    for (int ray = 0; ray < RAYS; ray++) {
      Vec3 up = Warp.cosineHemisphere(new Point2(even(ray, 0), even(ray, 1)));
      directions[ray] = new Vec3(up.x(), up.z(), up.y());
      lengths[ray] = reach * even(ray, 2);
    }
  }

  /** Returns a coordinate of a point of an even sequence (Roberts 2018, "R3"), in [0,1). */
  private static double even(int point, int axis) {
    double x = .5 + (point + 1) * STEPS[axis];
    return x - Math.floor(x);
  }

  /** Returns the y of the ground. */
  double ground() {
    return ground;
  }

  /**
   * Returns what is blocked above a point of the ground, 0 to 1: a cubic B-spline of the corners
   * around it.
   */
  double at(double x, double z, RenderContext context) {
    double across = (x - left) / step;
    double along = (z - back) / step;
    if (!(across > -2 && across < columns + 1 && along > -2 && along < rows + 1)) {
      return 0;
    }
    int column = (int) Math.floor(across);
    int row = (int) Math.floor(along);
    double sum = 0;
    for (int j = 0; j < SPAN; j++) {
      double line = 0;
      for (int i = 0; i < SPAN; i++) {
        line += weight(i, across - column) * corner(column - 1 + i, row - 1 + j, context);
      }
      sum += weight(j, along - row) * line;
    }
    return sum;
  }

  /**
   * Returns the weight of a corner in a uniform cubic B-spline.
   *
   * @param corner 0 to 3
   * @param part where the point is between corners 1 and 2, 0 to 1
   */
  private static double weight(int corner, double part) {
    double distance = Math.abs(part + 1 - corner);
    double rest = 2 - distance;
    return distance < 1
        ? (4 - 3 * distance * distance * rest) / 6
        : rest * rest * rest / 6;
  }

  private double corner(int column, int row, RenderContext context) {
    if (column < 0 || column >= columns || row < 0 || row >= rows) {
      return 0;
    }
    float known = corners[row * columns + column];
    if (!Float.isNaN(known)) {
      return known;
    }
    float found = (float) blocked(column, row, context);
    corners[row * columns + column] = found;
    return found;
  }

  /**
   * Returns the part of rays towards the sky that is blocked. Their lengths differ, so that what is
   * half as far away as the reach blocks half as much.
   */
  private double blocked(int column, int row, RenderContext context) {
    Vec3 point = new Vec3(left + column * step, ground, back + row * step);
    double blocked = 0;
    for (int ray = 0; ray < RAYS; ray++) {
      blocked += context.blocked(scene, point, directions[ray], lengths[ray]);
    }
    return blocked / RAYS;
  }
}
