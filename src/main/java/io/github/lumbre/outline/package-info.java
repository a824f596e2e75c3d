/**
 * The lines of a technical drawing: silhouettes, creases and borders of the meshes of a scene, as
 * far as a camera sees them.
 *
 * <p>{@link io.github.lumbre.outline.Outlines} holds the edges of a scene and returns {@link
 * io.github.lumbre.drawing.Strokes} for a camera. Edges come from the meshes, so that lines are
 * exact at any size of the picture. Rays find which parts of an edge other surfaces hide (Appel
 * 1967, "The notion of quantitative invisibility and the machine rendering of solids", is the
 * analytic ancestor).
 */
@NullMarked
package io.github.lumbre.outline;

import org.jspecify.annotations.NullMarked;
