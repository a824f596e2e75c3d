/**
 * Lines on finished pictures. {@link io.github.lumbre.drawing.Canvas} draws {@link
 * io.github.lumbre.drawing.Strokes} with a {@link io.github.lumbre.drawing.Pen}. {@link
 * io.github.lumbre.drawing.StrokeFont} has the strokes of texts.
 *
 * <p>Coordinates are in pixels from the top left corner of the picture: x to the right, y down. The
 * center of the first pixel is (0.5, 0.5).
 *
 * <p>The part of a pixel's area that strokes cover is mixed with the picture in linear light: a
 * black line of one pixel's width removes the same light wherever it lies between the pixels. {@link
 * io.github.lumbre.drawing.DisplayLight} applies exposure and tone curve first, so that a line has
 * this weight and the color of its pen also on bright surfaces. The results are bit-identical on
 * every machine.
 */
@NullMarked
package io.github.lumbre.drawing;

import org.jspecify.annotations.NullMarked;
