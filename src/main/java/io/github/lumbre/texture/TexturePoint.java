package io.github.lumbre.texture;

/** Where on a surface a texture is asked: any finite (u, v). */
public record TexturePoint(double u, double v) {}
