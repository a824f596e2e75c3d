package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;

/**
 * What a hierarchy is built over: first the triangles of all meshes, in their order, then the other
 * bounded shapes. Unbounded shapes stand apart; empty ones are left out.
 */
final class BvhItems {
  private final List<Shape> all;
  private final int[] triangleShape;
  private final int[] triangleElement;
  private final List<Integer> bounded = new ArrayList<>();
  private final List<Integer> unbounded = new ArrayList<>();
  private final double[] boxes;
  private final double[] scratch = new double[9];
  private final double margin;

  /**
   * @param margin how much wider than their contents the boxes are, relative to the largest
   *     coordinate
   */
  BvhItems(List<Shape> all, double margin) {
    this.all = all;
    this.margin = margin;
    int triangles = 0;
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i) instanceof Mesh mesh) {
        triangles = Math.addExact(triangles, mesh.triangles().triangleCount());
      } else if (!all.get(i).bounds().isEmpty()) {
        (all.get(i).bounds().isFinite() ? bounded : unbounded).add(i);
      }
    }
    triangleShape = new int[triangles];
    triangleElement = new int[triangles];
    boxes = new double[Math.multiplyExact(6, triangles + bounded.size())];
    addTriangles();
    for (int i = 0; i < bounded.size(); i++) {
      Bounds3 box = all.get(bounded.get(i)).bounds();
      store(triangles + i, box.min(), box.max());
    }
  }

  private void addTriangles() {
    int item = 0;
    for (int shape = 0; shape < all.size(); shape++) {
      if (all.get(shape) instanceof Mesh mesh) {
        TriangleMesh data = mesh.triangles();
        for (int element = 0; element < data.triangleCount(); element++, item++) {
          triangleShape[item] = shape;
          triangleElement[item] = element;
          data.copyVertices(element, scratch, 0);
          store(item, corner(true), corner(false));
        }
      }
    }
  }

  private Vec3 corner(boolean low) {
    double[] c = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      double p = scratch[axis];
      double q = scratch[axis + 3];
      double r = scratch[axis + 6];
      c[axis] = low ? Math.min(p, Math.min(q, r)) : Math.max(p, Math.max(q, r));
    }
    return new Vec3(c[0], c[1], c[2]);
  }

  private void store(int item, Vec3 min, Vec3 max) {
    double pad = margin * Math.max(min.maxAbs(), max.maxAbs());
    for (int axis = 0; axis < 3; axis++) {
      boxes[6 * item + 2 * axis] = min.get(axis) - pad;
      boxes[6 * item + 2 * axis + 1] = max.get(axis) + pad;
    }
  }

  boolean isEmpty() {
    return boxes.length == 0;
  }

  /** Returns six doubles an item: minimum and maximum on x, y, z. */
  double[] boxes() {
    return boxes;
  }

  /** Returns how many of the items, the first ones, are triangles. */
  int triangleCount() {
    return triangleShape.length;
  }

  /** Returns the triangles in a given order of their item numbers. */
  Triangles triangles(int[] order) {
    double[] vertices = new double[Math.multiplyExact(9, order.length)];
    int[] shape = new int[order.length];
    int[] element = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      shape[i] = triangleShape[order[i]];
      element[i] = triangleElement[order[i]];
      ((Mesh) all.get(shape[i])).triangles().copyVertices(element[i], vertices, 9 * i);
    }
    return new Triangles(vertices, shape, element);
  }

  /** Returns the numbers of the shapes in a given order of their item numbers. */
  int[] shapeNumbers(int[] order) {
    int[] numbers = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      numbers[i] = bounded.get(order[i] - triangleCount());
    }
    return numbers;
  }

  int[] unboundedNumbers() {
    return unbounded.stream().mapToInt(Integer::intValue).toArray();
  }

  /** Returns the shapes with the given numbers. */
  Shape[] shapes(int[] numbers) {
    Shape[] shapes = new Shape[numbers.length];
    for (int i = 0; i < numbers.length; i++) {
      shapes[i] = all.get(numbers[i]);
    }
    return shapes;
  }
}
