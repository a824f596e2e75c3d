/**
 * Textures: values that vary over a surface.
 *
 * <p>A {@link io.github.lumbre.texture.Texture} returns a color, and a {@link
 * io.github.lumbre.texture.ScalarTexture} returns a number, at a {@link
 * io.github.lumbre.texture.TexturePoint}, the surface's (u, v). u = 0 is the left edge of an image
 * and v = 0 its <b>lower</b> edge. Both may have any finite value, because textures repeat.
 * Textures are observably immutable and thread-safe.
 *
 * <p>{@link io.github.lumbre.texture.ImageTexture} reads a picture; a {@link
 * io.github.lumbre.texture.UvMapping} translates and scales any texture, {@link
 * io.github.lumbre.texture.TintedTexture} multiplies it by a constant, and {@link
 * io.github.lumbre.texture.RedChannel} turns it into a scalar texture.
 *
 * <p>Wood, marble, clouds and Voronoi cells are procedural textures with a width and height in
 * texels. Each is a {@link io.github.lumbre.texture.TexelTexture}, computed from {@link
 * io.github.lumbre.texture.Noise} or from random points. They depend only on a seed and their
 * parameters, and tile.
 */
package io.github.lumbre.texture;
