/**
 * How surfaces scatter light.
 *
 * <p>A {@link io.github.lumbre.material.Material} looks at a hit, reads its textures and answers
 * with a {@link io.github.lumbre.material.Bsdf}, which works in the local shading frame: normal on
 * +z, {@code wo} to the viewer and {@code wi} to the light, both of unit length and away from the
 * surface. {@code evaluate} includes |cos θi|; densities are per solid angle. The two sides of a
 * surface differ by the sign of z alone; opaque materials scatter on both.
 *
 * <p>What is carried along a path is radiance over squared index of refraction, which refraction
 * leaves unchanged: no factor appears when light enters or leaves glass.
 */
package io.github.lumbre.material;
