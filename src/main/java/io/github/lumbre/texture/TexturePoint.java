package io.github.lumbre.texture;

/** Texture coordinates (u, v), any finite numbers. */
public record TexturePoint(double u, double v) {}
