package io.github.lumbre.geometry;

import io.github.lumbre.image.Rgb;

/**
 * A point of a mesh's triangle, at which further vertex attributes are interpolated when a material
 * needs them. Mutable; each {@link SurfaceHit} has one.
 */
final class MeshPoint {
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

  /** Returns whether the mesh has a second set of texture coordinates. */
  boolean hasSecondUv() {
    return mesh.attributes().uv1().length > 0;
  }

  /**
   * Returns a coordinate of the second set.
   *
   * @param axis 0 for u, 1 for v
   */
  double secondUv(int axis) {
    double[] uv = mesh.attributes().uv1();
    return mix(
        uv[2 * mesh.vertex(triangle, 0) + axis],
        uv[2 * mesh.vertex(triangle, 1) + axis],
        uv[2 * mesh.vertex(triangle, 2) + axis]);
  }

  /** Returns the vertex color; white if the mesh has none. */
  Rgb color() {
    return mesh.attributes().colors().length == 0
        ? Rgb.WHITE
        : new Rgb(color(0), color(1), color(2));
  }

  /** Returns the vertex alpha; 1 if the mesh has none. */
  double alpha() {
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
