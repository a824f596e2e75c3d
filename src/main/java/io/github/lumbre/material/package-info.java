/**
 * Materials: how surfaces scatter light.
 *
 * <p>A {@link io.github.lumbre.material.Material} evaluates its textures at a hit and returns a
 * {@link io.github.lumbre.material.Bsdf}. The BSDF works in the local shading frame, whose normal
 * is +z. {@code wo} points to the viewer and {@code wi} to the light; both are unit vectors that
 * point away from the surface. {@code evaluate} includes |cos θi|; densities are per solid angle.
 * The two sides of a surface differ only by the sign of z, and opaque materials scatter on both.
 *
 * <p>A path carries radiance divided by the squared index of refraction, which refraction leaves
 * unchanged. BSDFs therefore apply no factor when light enters or leaves glass.
 */
@NullMarked
package io.github.lumbre.material;

import org.jspecify.annotations.NullMarked;
