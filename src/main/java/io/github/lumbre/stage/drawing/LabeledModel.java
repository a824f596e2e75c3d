package io.github.lumbre.stage.drawing;

import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.math.Vec3;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A model in a picture.
 *
 * @param projection from the axes and the unit of the file to the pixels of the picture
 * @param axes the directions of the file's axes as the camera sees them: right, up, forward
 * @param min the least coordinates of the model, in the file's unit
 * @param max the largest coordinates
 * @param unit the name of the file's unit; empty if it has none
 */
public record LabeledModel(
    Projection projection, List<Vec3> axes, Vec3 min, Vec3 max, String unit) {
  private static final int CORNERS = 8;

  public LabeledModel {
    axes = List.copyOf(axes);
  }

  /** Returns a corner of the box; the bits of its number choose between min and max. */
  private Vec3 corner(int number) {
    return new Vec3(
        (number & 1) == 0 ? min.x() : max.x(),
        (number & 2) == 0 ? min.y() : max.y(),
        (number & 4) == 0 ? min.z() : max.z());
  }

  /** Returns the positions of the box's corners in the picture, with their depths. */
  List<Vec3> corners() {
    return IntStream.range(0, CORNERS).mapToObj(i -> projection.pixel(corner(i))).toList();
  }

  /** Returns whether all of the box is in front of the camera. */
  boolean isInFront() {
    return projection.isParallel() || corners().stream().allMatch(corner -> corner.z() > 0);
  }

  /**
   * Returns the pixels of a length of 1 in the plane through the middle of the box that faces the
   * camera.
   */
  double pixelsPerUnit() {
    Vec3 right = new Vec3(axes.get(0).x(), axes.get(1).x(), axes.get(2).x());
    Vec3 middle = min.times(.5).plus(max.times(.5));
    double length = max.minus(min).length();
    double from = projection.pixel(middle.plus(-.5 * length, right)).x();
    return (projection.pixel(middle.plus(.5 * length, right)).x() - from) / length;
  }
}
