package io.github.lumbre.lab.checks;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;

/** A closed latitude-longitude mesh around the origin, and its vertices. */
record Ball(Vec3[] vertices, int[] indices) {
  /**
   * @param n number of latitudes and number of longitudes
   * @param jitter radii lie in [1 - jitter, 1]
   */
  static Ball of(int n, double jitter) {
    Draws draws = new Draws(n);
    Vec3[] vertices = new Vec3[n * (n - 1) + 2];
    vertices[0] = Vec3.Y;
    vertices[vertices.length - 1] = Vec3.Y.negated();
    for (int i = 0; i < n * (n - 1); i++) {
      double latitude = .25 - .5 * (Math.floorDiv(i, n) + 1) / n;
      double longitude = (double) (i % n) / n;
      double across = Elementary.cosTurns(latitude);
      Vec3 direction =
          new Vec3(
              across * Elementary.cosTurns(longitude),
              Elementary.sinTurns(latitude),
              across * Elementary.sinTurns(longitude));
      vertices[i + 1] = direction.times(1 - jitter * draws.unit());
    }
    return new Ball(vertices, indices(n));
  }

  private static int[] indices(int n) {
    int[] indices = new int[6 * n * (n - 1)];
    int size = 0;
    int last = n * (n - 1) + 1;
    for (int column = 0; column < n; column++) {
      int next = (column + 1) % n;
      size = add(indices, size, 0, 1 + column, 1 + next);
      for (int row = 0; row < n - 2; row++) {
        int above = 1 + row * n;
        int below = above + n;
        size = add(indices, size, above + column, below + column, below + next);
        size = add(indices, size, above + column, below + next, above + next);
      }
      int bottom = 1 + (n - 2) * n;
      size = add(indices, size, last, bottom + next, bottom + column);
    }
    return indices;
  }

  private static int add(int[] indices, int size, int a, int b, int c) {
    indices[size] = a;
    indices[size + 1] = b;
    indices[size + 2] = c;
    return size + 3;
  }

  TriangleMesh mesh() {
    double[] positions = new double[3 * vertices.length];
    for (int i = 0; i < vertices.length; i++) {
      positions[3 * i] = vertices[i].x();
      positions[3 * i + 1] = vertices[i].y();
      positions[3 * i + 2] = vertices[i].z();
    }
    return TriangleMesh.of(positions, new double[0], new double[0], indices);
  }

  /** Samples a random triangle and returns its three vertices. */
  Vec3[] triangle(Draws draws) {
    int i = 3 * draws.below(indices.length / 3);
    return new Vec3[] {vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]};
  }
}
