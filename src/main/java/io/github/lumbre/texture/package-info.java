/**
 * Values that vary over a surface.
 *
 * <p>A {@link io.github.lumbre.texture.Texture} gives a colour and a {@link
 * io.github.lumbre.texture.ScalarTexture} a number at a {@link
 * io.github.lumbre.texture.TexturePoint}, the surface's (u, v): u = 0 is the left column of an
 * image and v = 0 its <b>bottom</b> row; both may take any value, textures repeat. Textures are
 * immutable and safe for use by any thread.
 *
 * <p>{@link io.github.lumbre.texture.ImageTexture} reads a picture; a {@link
 * io.github.lumbre.texture.UvMapping} moves and scales any texture, {@link
 * io.github.lumbre.texture.TintedTexture} multiplies it by a constant, and {@link
 * io.github.lumbre.texture.RedChannel} makes a number of it.
 */
package io.github.lumbre.texture;
