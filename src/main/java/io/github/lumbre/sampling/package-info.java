/**
 * Random numbers and how to warp them.
 *
 * <p>A {@link io.github.lumbre.sampling.Sampler} gives the numbers, each an address of (seed,
 * pixel, sample, dimension) and not the next of a stream; {@link io.github.lumbre.sampling.Warp}
 * turns two of them into a point of a disc, a hemisphere, a cone or a triangle; the distributions
 * choose in proportion to weights.
 *
 * <p>All uniform numbers lie in [0,1). A warp and its density share a stem; densities are per solid
 * angle unless they say per area. Local frames have the normal on +z.
 */
package io.github.lumbre.sampling;

