/**
 * Drawings on finished pictures: the lines of a technical drawing, labels, and the strokes that
 * both consist of.
 *
 * <p>{@link io.github.lumbre.stage.drawing.Outlines} holds the silhouettes, creases and borders of
 * the meshes of a scene, and finds its lines for a camera. They come from the meshes, so that lines
 * are exact at any size of the picture. Rays find which parts of an edge other surfaces hide (Appel
 * 1967, "The notion of quantitative invisibility and the machine rendering of solids", is the
 * analytic ancestor).
 *
 * <p>{@link io.github.lumbre.stage.drawing.LineDrawing} draws these lines on pixels, and {@link
 * io.github.lumbre.stage.drawing.VectorSheet} makes vectors of them: its {@code Sketch} has the
 * visible and the hidden lines of each part, each place once, and {@code Chains} joins them. {@code
 * Surfaces} has what is between the lines of a drawing without light.
 *
 * <p>{@link io.github.lumbre.stage.drawing.Labels} places axes, a scale bar, the dimensions of the
 * box around the model, and names on a {@code LabelSheet}, which knows the room that is left.
 *
 * <p>{@link io.github.lumbre.stage.drawing.Canvas} draws strokes with a {@link
 * io.github.lumbre.stage.drawing.Pen}; {@link io.github.lumbre.stage.drawing.StrokeFont} has those
 * of texts. Coordinates are in pixels from the top left corner of the picture: x to the right, y
 * down. The center of the first pixel is (0.5, 0.5). The part of a pixel's area that strokes cover
 * is mixed with the picture in linear light: a black line of one pixel's width removes the same
 * light wherever it lies between the pixels. {@link io.github.lumbre.stage.drawing.DisplayLight}
 * applies exposure and tone curve first, so that a line has this weight and the color of its pen
 * also on bright surfaces. The results are bit-identical on every machine.
 */
@NullMarked
package io.github.lumbre.stage.drawing;

import org.jspecify.annotations.NullMarked;
