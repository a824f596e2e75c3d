package io.github.lumbre.math;

/**
 * A point in two dimensions: on the film, on the lens or in a texture, or two random numbers in
 * [0,1).
 */
public record Point2(double x, double y) {}
