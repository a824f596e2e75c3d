package io.github.lumbre.stage.drawing;

/** The numbers of the parts of a model in its scene. */
@FunctionalInterface
public interface PartOf {
  /** Everything is one part. */
  PartOf ONE = (primitive, triangle) -> 0;

  /** Returns the number of the part that a triangle of a primitive belongs to. */
  int number(int primitive, int triangle);
}
