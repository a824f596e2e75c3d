package io.github.lumbre.texture;

import io.github.lumbre.image.Rgb;

/**
 * Texture coordinates (u, v), any finite numbers: a point of a surface whose sets of coordinates
 * are the same, and whose vertices have no colors.
 */
public record TexturePoint(double u, double v) implements SurfacePoint {
  @Override
  public double u(int set) {
    return u;
  }

  @Override
  public double v(int set) {
    return v;
  }

  @Override
  public Rgb vertexColor() {
    return Rgb.WHITE;
  }

  @Override
  public double vertexAlpha() {
    return 1;
  }
}
