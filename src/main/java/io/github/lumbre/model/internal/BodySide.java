package io.github.lumbre.model.internal;

import io.github.lumbre.math.Vec3;

/** On which side of a mesh its fronts are, if it is nearly closed. */
public final class BodySide {
  /**
   * A mesh is closed as far as matters here if the sum of the vectors of its areas is at most this
   * part of its area; for closed meshes, it is 0.
   */
  private static final double MOST_OPEN = .2;

  /** The least volume of a body, divided by the area to the power of 1.5; .094 for spheres. */
  private static final double LEAST_VOLUME = 1e-3;

  private BodySide() {}

  /** Returns 1 if the fronts of a closed body are outside, -1 if they are inside, 0 if unknown. */
  public static int of(ModelGeometry mesh) {
    Vec3 middle = middle(mesh.positions());
    Vec3 open = Vec3.ZERO;
    double area = 0;
    double volume = 0;
    int[] indices = mesh.indices();
    for (int i = 0; i < indices.length; i += 3) {
      Vec3 a = vertex(mesh, indices[i]).minus(middle);
      Vec3 b = vertex(mesh, indices[i + 1]).minus(middle);
      Vec3 c = vertex(mesh, indices[i + 2]).minus(middle);
      Vec3 cross = b.minus(a).cross(c.minus(a));
      open = open.plus(cross);
      area += cross.length() / 2;
      volume += a.dot(cross) / 6;
    }
    boolean isClosed = open.length() / 2 <= MOST_OPEN * area;
    boolean isBody = Math.abs(volume) > LEAST_VOLUME * area * Math.sqrt(area);
    return isClosed && isBody ? (int) Math.signum(volume) : 0;
  }

  private static Vec3 middle(double[] positions) {
    Vec3 sum = Vec3.ZERO;
    for (int i = 0; i < positions.length; i += 3) {
      sum = sum.plus(new Vec3(positions[i], positions[i + 1], positions[i + 2]));
    }
    return positions.length == 0 ? sum : sum.times(3. / positions.length);
  }

  private static Vec3 vertex(ModelGeometry mesh, int index) {
    double[] p = mesh.positions();
    return new Vec3(p[3 * index], p[3 * index + 1], p[3 * index + 2]);
  }
}
