package io.github.lumbre.geometry;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.SurfacePoint;

/**
 * A point of a mesh's triangle, at which further vertex attributes are interpolated when a material
 * needs them. Mutable; each {@link SurfaceHit} has one.
 */
final class MeshPoint implements SurfacePoint {
  private TriangleMesh mesh;
  private int triangle;
  private double b1, b2;

  /** Moves to the point with barycentric weights (1 − b1 − b2, b1, b2). */
  void moveTo(TriangleMesh newMesh, int newTriangle, double newB1, double newB2) {
    mesh = newMesh;
    triangle = newTriangle;
    b1 = newB1;
    b2 = newB2;
  }

  @Override
  public double u(int set) {
    if (set == 1 && mesh.attributes().uv1().length > 0) {
      return secondUv(0);
    }
    double a = mesh.uv(triangle, 0).u();
    return a + b1 * (mesh.uv(triangle, 1).u() - a) + b2 * (mesh.uv(triangle, 2).u() - a);
  }

  @Override
  public double v(int set) {
    if (set == 1 && mesh.attributes().uv1().length > 0) {
      return secondUv(1);
    }
    double a = mesh.uv(triangle, 0).v();
    return a + b1 * (mesh.uv(triangle, 1).v() - a) + b2 * (mesh.uv(triangle, 2).v() - a);
  }

  /**
   * Returns a coordinate of the second set.
   *
   * @param axis 0 for u, 1 for v
   */
  private double secondUv(int axis) {
    double[] uv = mesh.attributes().uv1();
    return mix(
        uv[2 * mesh.vertex(triangle, 0) + axis],
        uv[2 * mesh.vertex(triangle, 1) + axis],
        uv[2 * mesh.vertex(triangle, 2) + axis]);
  }

  @Override
  public Rgb vertexColor() {
    return mesh.attributes().colors().length == 0
        ? Rgb.WHITE
        : new Rgb(color(0), color(1), color(2));
  }

  @Override
  public double vertexAlpha() {
    return mesh.attributes().colors().length == 0 ? 1 : color(3);
  }

  private double color(int channel) {
    float[] colors = mesh.attributes().colors();
    return mix(
        colors[4 * mesh.vertex(triangle, 0) + channel],
        colors[4 * mesh.vertex(triangle, 1) + channel],
        colors[4 * mesh.vertex(triangle, 2) + channel]);
  }

  private double mix(double a, double b, double c) {
    return (1 - b1 - b2) * a + b1 * b + b2 * c;
  }
}
