/**
 * Values that vary over a surface.
 *
 * <p>A {@link io.github.lumbre.texture.Texture} gives a colour and a {@link
 * io.github.lumbre.texture.ScalarTexture} a number at a {@link
 * io.github.lumbre.texture.TexturePoint}, the surface's (u, v): u = 0 is the left column of an
 * image and v = 0 its <b>bottom</b> row; both may take any value, textures repeat. Textures are
 * immutable and safe for use by any thread.
 */
package io.github.lumbre.texture;
