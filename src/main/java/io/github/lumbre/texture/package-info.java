/**
 * Textures: values that vary over a surface, or over the directions of a sky.
 *
 * <p>A {@link io.github.lumbre.texture.Texture} returns a color, and a {@link
 * io.github.lumbre.texture.ScalarTexture} returns a number, at a {@link
 * io.github.lumbre.texture.TexturePoint}, the surface's (u, v). u = 0 is the left edge of an image
 * and v = 0 its <b>lower</b> edge. Both may have any finite value, because textures repeat.
 * Textures are observably immutable and thread-safe.
 *
 * <p>A {@link io.github.lumbre.texture.UvMapping} translates and scales any texture, and a {@link
 * io.github.lumbre.texture.NormalMap} bends normals by one. The package {@code internal} has the
 * kinds of textures.
 */
@NullMarked
package io.github.lumbre.texture;

import org.jspecify.annotations.NullMarked;
