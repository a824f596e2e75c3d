package io.github.lumbre.geometry;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Shapes to shoot at, inside the unit sphere or so. */
public enum BenchmarkShapes {
  /** A wavy ball of about 20000 triangles. */
  MESH {
    @Override
    List<Shape> make() {
      return List.of(mesh(20_000));
    }
  },

  /** Twelve turned boxes, and one around them. */
  BOXES {
    @Override
    List<Shape> make() {
      SplittableRandom random = new SplittableRandom(2);
      List<Shape> boxes = new ArrayList<>();
      boxes.add(new Box(Transform.IDENTITY, 8, 8, 8));
      for (int i = 0; i < 12; i++) {
        Transform place = Transform.translation(vector(random, 1.4));
        Transform turned = place.times(Transform.rotationDegrees(vector(random, 360)));
        boxes.add(new Box(turned, .3, .4, .5));
      }
      return boxes;
    }
  };

  private static final double WAVES = 9;

  abstract List<Shape> make();

  private static Vec3 vector(SplittableRandom random, double width) {
    return new Vec3(
        width * (random.nextDouble() - .5),
        width * (random.nextDouble() - .5),
        width * (random.nextDouble() - .5));
  }

  /** Returns a wavy ball of about so many triangles, in rows from pole to pole. */
  static Mesh mesh(int triangles) {
    int rows = (int) Math.sqrt(triangles / 4.0);
    int columns = 2 * rows;
    double[] positions = new double[3 * (rows + 1) * (columns + 1)];
    int[] indices = new int[6 * rows * columns];
    for (int row = 0, vertex = 0; row <= rows; row++) {
      for (int column = 0; column <= columns; column++, vertex++) {
        store(point((double) column / columns, (double) row / rows), positions, 3 * vertex);
      }
    }
    for (int row = 0, next = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++, next += 6) {
        int corner = row * (columns + 1) + column;
        int below = corner + columns + 1;
        int[] square = {corner, below, corner + 1, corner + 1, below, below + 1};
        System.arraycopy(square, 0, indices, next, square.length);
      }
    }
    TriangleMesh mesh = TriangleMesh.of(positions, new double[0], new double[0], indices);
    return Mesh.baked(mesh, Transform.IDENTITY);
  }

  /** Returns a point of the ball, given in turns around it and in half turns from the pole. */
  private static Vec3 point(double around, double down) {
    double radius = .8 + .1 * Elementary.sinTurns(WAVES * around) * Elementary.sinTurns(3 * down);
    double sin = Elementary.sinTurns(.5 * down);
    return new Vec3(
            sin * Elementary.cosTurns(around),
            sin * Elementary.sinTurns(around),
            Elementary.cosTurns(.5 * down))
        .times(radius);
  }

  private static void store(Vec3 point, double[] target, int at) {
    target[at] = point.x();
    target[at + 1] = point.y();
    target[at + 2] = point.z();
  }
}
