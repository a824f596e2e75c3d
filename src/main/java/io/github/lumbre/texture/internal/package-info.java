/**
 * The kinds of textures, skies among them, which the module does not export. Programs get them from
 * {@link io.github.lumbre.texture.Texture}, scenes name them.
 *
 * <p>{@link io.github.lumbre.texture.internal.ImageTexture} reads a picture; {@link
 * io.github.lumbre.texture.internal.TintedTexture} multiplies it by a constant, and {@link
 * io.github.lumbre.texture.internal.RedChannel} turns it into a scalar texture.
 *
 * <p>Wood, marble, clouds and Voronoi cells are procedural textures with a width and height in
 * texels. Each is a {@link io.github.lumbre.texture.internal.TexelTexture}, computed from {@link
 * io.github.lumbre.texture.internal.Noise} or from random points. They depend only on a seed and
 * their parameters, and tile.
 */
package io.github.lumbre.texture.internal;
