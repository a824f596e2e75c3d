package io.github.lumbre.camera.internal;

import io.github.lumbre.math.internal.Range;

/** The valid numbers of lenses. */
public final class LensRanges {
  /** The full vertical angle of view, in degrees. */
  public static final Range FIELD_OF_VIEW = Range.open(0, 180);

  /** The distance of the plane of focus, which programs may state as infinite. */
  public static final Range FOCUS_DISTANCE =
      new Range(0, Double.MAX_VALUE, x -> x > 0, Range.POSITIVE.ifLow(), Range.POSITIVE.ifHigh());

  /** Half the height of a cylindrical film on the unit cylinder. */
  public static final Range CYLINDER_HEIGHT = Range.closed(0, 1e150);

  /** The full angle of view of a fisheye, in degrees. */
  public static final Range FISH_EYE_ANGLE = Range.above(0, 360);

  private LensRanges() {}
}
