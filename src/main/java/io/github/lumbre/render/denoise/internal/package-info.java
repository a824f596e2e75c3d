/**
 * Denoised frames of a sequence, which share what they know of surfaces: {@link
 * io.github.lumbre.render.denoise.internal.SeenFrame} is what a frame knows, {@link
 * io.github.lumbre.render.denoise.internal.PosedSurfaces} says where its surfaces are, and {@link
 * io.github.lumbre.render.denoise.internal.SharedFrames} mixes frames along the paths of surface
 * points.
 */
@NullMarked
package io.github.lumbre.render.denoise.internal;

import org.jspecify.annotations.NullMarked;
