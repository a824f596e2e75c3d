/**
 * Values that vary over a surface.
 *
 * <p>A {@link io.github.lumbre.texture.Texture} gives a colour and a {@link
 * io.github.lumbre.texture.ScalarTexture} a number at a {@link
 * io.github.lumbre.texture.TexturePoint}, the surface's (u, v): u = 0 is the left column of an
 * image and v = 0 its <b>bottom</b> row; both may take any value, textures repeat. Textures are
 * immutable, or look so, and safe for use by any thread.
 *
 * <p>{@link io.github.lumbre.texture.ImageTexture} reads a picture; a {@link
 * io.github.lumbre.texture.UvMapping} moves and scales any texture, {@link
 * io.github.lumbre.texture.TintedTexture} multiplies it by a constant, and {@link
 * io.github.lumbre.texture.RedChannel} makes a number of it.
 *
 * <p>Wood, marble, clouds and Voronoi cells are computed and look like pictures of their width and
 * height: each is a {@link io.github.lumbre.texture.TexelTexture}, made of {@link
 * io.github.lumbre.texture.Noise} or of random points. They follow from a seed alone, and tile.
 */
package io.github.lumbre.texture;

