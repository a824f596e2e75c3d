package io.github.lumbre.render;

/**
 * A rectangle of the full frame that one thread renders.
 *
 * @param x of its left column
 * @param y of its top row
 * @param width at least 1
 * @param height at least 1
 */
public record Bucket(int x, int y, int width, int height) {}
