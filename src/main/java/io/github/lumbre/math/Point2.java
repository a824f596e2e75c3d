package io.github.lumbre.math;

/** A point of a plane: of the film, of the lens, of a texture, or two random numbers in [0,1). */
public record Point2(double x, double y) {}
