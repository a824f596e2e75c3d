package io.github.lumbre.geometry;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.SurfacePoint;
import io.github.lumbre.texture.TexturePoint;

/** A point on a surface, with its texture coordinates and a mesh's further data. Mutable. */
abstract class AttributedPoint implements SurfacePoint {
  double u, v;

  /** Where further vertex attributes are; used only if {@link #hasAttributes}. */
  private final MeshPoint meshPoint = new MeshPoint();

  boolean hasAttributes;

  /** Adds a mesh's further vertex attributes, at barycentric weights (1 − b1 − b2, b1, b2). */
  final void addAttributes(TriangleMesh mesh, int triangle, double b1, double b2) {
    meshPoint.moveTo(mesh, triangle, b1, b2);
    hasAttributes = true;
  }

  /** Returns the texture coordinates at the point. */
  public final TexturePoint texture() {
    return new TexturePoint(u, v);
  }

  @Override
  public final double u(int set) {
    return set == 1 && hasAttributes ? meshPoint.u(1) : u;
  }

  @Override
  public final double v(int set) {
    return set == 1 && hasAttributes ? meshPoint.v(1) : v;
  }

  @Override
  public final Rgb vertexColor() {
    return hasAttributes ? meshPoint.vertexColor() : Rgb.WHITE;
  }

  @Override
  public final double vertexAlpha() {
    return hasAttributes ? meshPoint.vertexAlpha() : 1;
  }
}
