package io.github.lumbre.model.format.ies;

import java.util.Arrays;
import java.util.Optional;

/**
 * The horizontal angles of a whole turn, and which row of the file each has. The range of the
 * angles in the file states the symmetry of the lamp. Immutable.
 *
 * @param angles in degrees; the last one is the first plus 360
 * @param rows for each angle the index of its row in the file
 */
record HorizontalAngles(double[] angles, int[] rows) {
  /**
   * Returns the angles of a whole turn; empty if the range has no meaning. From 0 to 0, the lamp is
   * the same all around; from 0 to 90, in each quadrant; from 0 to 180, on both sides of the plane
   * of 0 and 180; from 90 to 270, of the plane of 90 and 270. From 0 to more than 180, it has no
   * symmetry; the angle 360 may be missing.
   *
   * @param inFile ascending, in degrees, in [0,360]
   */
  static Optional<HorizontalAngles> of(double[] inFile) {
    int[] rows = new int[inFile.length];
    Arrays.setAll(rows, i -> i);
    HorizontalAngles file = new HorizontalAngles(inFile, rows);
    double first = inFile[0];
    double last = inFile[inFile.length - 1];
    if (first == 90 && last == 270) {
      return Optional.of(file.mirrored());
    }
    if (first != 0) {
      return Optional.empty();
    }
    if (last == 90) {
      return Optional.of(file.mirrored().mirrored());
    }
    if (last == 180) {
      return Optional.of(file.mirrored());
    }
    if (last == 360) {
      return Optional.of(file);
    }
    return last == 0 || last > 180 ? Optional.of(file.closed()) : Optional.empty();
  }

  /** Returns these angles and, in reverse, their mirror images about the last one. */
  private HorizontalAngles mirrored() {
    int last = angles.length - 1;
    double[] both = Arrays.copyOf(angles, 2 * last + 1);
    int[] rowsOfBoth = Arrays.copyOf(rows, both.length);
    for (int i = 1; i <= last; i++) {
      both[last + i] = 2 * angles[last] - angles[last - i];
      rowsOfBoth[last + i] = rows[last - i];
    }
    return new HorizontalAngles(both, rowsOfBoth);
  }

  /** Returns these angles and 360, which has the row of 0. */
  private HorizontalAngles closed() {
    double[] more = Arrays.copyOf(angles, angles.length + 1);
    more[angles.length] = 360;
    return new HorizontalAngles(more, Arrays.copyOf(rows, more.length));
  }
}
