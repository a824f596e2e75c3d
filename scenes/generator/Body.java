package generator;

/**
 * One solid of a sculpture: its shape, what covers it, and the width of the grid it is cut from.
 */
record Body(Sdf shape, Paint paint, double cell) {

  Body mirrored() {
    return new Body(shape.mirrored(), paint.mirrored(), cell);
  }
}
