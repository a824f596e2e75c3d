/**
 * Labels on finished pictures of models: axes, a scale bar, the dimensions of the box around the
 * model, and names. {@link io.github.lumbre.label.Labels} places them on a {@code LabelSheet},
 * which knows the room that is left and draws all of it with strokes.
 *
 * <p>Positions are in pixels from the top left corner of the picture, y down. Points of the model
 * are in the axes and the unit of its file.
 */
@NullMarked
package io.github.lumbre.label;

import org.jspecify.annotations.NullMarked;
