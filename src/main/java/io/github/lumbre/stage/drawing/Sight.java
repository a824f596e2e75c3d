package io.github.lumbre.stage.drawing;

/** How the camera sees a point of an edge. */
enum Sight {
  /** There is no line at the point: the surface continues. */
  NONE,
  VISIBLE,
  /** A surface in front hides it. */
  HIDDEN
}
