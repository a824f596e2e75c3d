/**
 * Random numbers and sampling of distributions.
 *
 * <p>A {@link io.github.lumbre.math.sampling.Sampler} returns random numbers by address (seed,
 * pixel, sample, dimension) instead of from a stream. The package {@code internal} maps two of them
 * to a point of a disk, hemisphere, cone or triangle, and selects in proportion to weights.
 *
 * <p>All uniform numbers are in [0,1). The method that returns a warp's density is named after the
 * warp, with the suffix {@code Pdf}. Densities are per solid angle unless stated otherwise. Local
 * frames have the normal on +z.
 */
@NullMarked
package io.github.lumbre.math.sampling;

import org.jspecify.annotations.NullMarked;
