package io.github.lumbre.render;

/**
 * A rectangle of the full frame that one thread renders.
 *
 * @param x the left column, in the full frame
 * @param y the top row, in the full frame
 * @param width at least 1
 * @param height at least 1
 */
public record Bucket(int x, int y, int width, int height) {}
