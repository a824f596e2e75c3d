package io.github.lumbre.stage.drawing;

/** What strokes are drawn on, one above the other. */
interface Easel {
  /** Draws strokes over what is there. */
  void draw(Strokes strokes, Pen pen);
}
