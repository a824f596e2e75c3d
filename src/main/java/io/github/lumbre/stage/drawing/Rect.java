package io.github.lumbre.stage.drawing;

/** A rectangle in a picture, in pixels. */
record Rect(double left, double top, double right, double bottom) {
  static Rect around(double x, double y, double width, double height) {
    return new Rect(x - .5 * width, y - .5 * height, x + .5 * width, y + .5 * height);
  }

  double width() {
    return right - left;
  }

  double height() {
    return bottom - top;
  }

  boolean overlaps(Rect other) {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }

  boolean isInside(Rect other) {
    return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
  }
}
