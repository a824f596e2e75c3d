package io.github.lumbre.render;

import io.github.lumbre.image.Rgb;

/**
 * The samples of a pixel in two parts, from whose difference its noise can be told. The first part
 * is the largest power of two below the number of all, so that it is a stratified whole, and if
 * their number is a power of two, so is the second.
 *
 * @param firstCount samples in the first part, at least 1
 * @param first their mean, to about five digits of its largest component
 * @param secondCount samples in the second part, 1 to {@code firstCount}
 * @param second their mean; rounding of the first may make it slightly negative
 */
public record PixelHalves(int firstCount, Rgb first, int secondCount, Rgb second) {}
