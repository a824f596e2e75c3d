package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;

/**
 * The items of a hierarchy: first the triangles of all meshes in order, then the other bounded
 * shapes. Unbounded shapes are kept separately; empty shapes are left out.
 */
final class BvhItems {
  /** The margin of a box on each side, relative to the largest coordinate of its contents. */
  static final double MARGIN = 16 * 0x1p-52;

  /**
   * The size of an item, relative to the whole extent, below which the float filter passes more
   * than twice the necessary candidates.
   */
  private static final double MIN_SIZE = 0x1p-18;

  private final List<Shape> all;
  private final int[] triangleShape;
  private final int[] triangleElement;
  private final List<Integer> bounded = new ArrayList<>();
  private final List<Integer> unbounded = new ArrayList<>();
  private final double[] boxes;
  private final double[] scratch = new double[9];

  BvhItems(List<Shape> all) {
    this.all = all;
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
          data.copyVertices(element, scratch);
          storeTriangle(item);
        }
      }
    }
  }

  /** Stores the box of the triangle whose vertices are in {@code scratch}. */
  private void storeTriangle(int item) {
    double size = 0;
    for (double coordinate : scratch) {
      size = Math.max(size, Math.abs(coordinate));
    }
    for (int axis = 0; axis < 3; axis++) {
      double p = scratch[axis];
      double q = scratch[axis + 3];
      double r = scratch[axis + 6];
      boxes[6 * item + 2 * axis] = Math.min(p, Math.min(q, r)) - MARGIN * size;
      boxes[6 * item + 2 * axis + 1] = Math.max(p, Math.max(q, r)) + MARGIN * size;
    }
  }

  private void store(int item, Vec3 min, Vec3 max) {
    double pad = MARGIN * Math.max(min.maxAbs(), max.maxAbs());
    for (int axis = 0; axis < 3; axis++) {
      boxes[6 * item + 2 * axis] = min.get(axis) - pad;
      boxes[6 * item + 2 * axis + 1] = max.get(axis) + pad;
    }
  }

  boolean isEmpty() {
    return count() == 0;
  }

  /** Returns the number of items. */
  int count() {
    return boxes.length / 6;
  }

  /** Returns whether the box of all items has a finite size. */
  boolean hasFiniteExtent() {
    return Double.isFinite(extent());
  }

  /**
   * Returns whether most items are much larger than the error of a float in the hierarchy's {@link
   * UnitSpace}.
   */
  boolean suitFloats() {
    double least = MIN_SIZE * extent();
    int large = 0;
    for (int item = 0; item < count(); item++) {
      if (size(6 * item) >= least) {
        large++;
      }
    }
    return large > count() / 2;
  }

  private double extent() {
    double extent = 0;
    for (int axis = 0; axis < 6; axis += 2) {
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (int at = axis; at < boxes.length; at += 6) {
        low = Math.min(low, boxes[at]);
        high = Math.max(high, boxes[at + 1]);
      }
      extent = Math.max(extent, high - low);
    }
    return extent;
  }

  private double size(int at) {
    double x = boxes[at + 1] - boxes[at];
    double y = boxes[at + 3] - boxes[at + 2];
    double z = boxes[at + 5] - boxes[at + 4];
    return Math.max(x, Math.max(y, z));
  }

  /** Returns six doubles per item: minimum and maximum on x, y, z. */
  double[] boxes() {
    return boxes;
  }

  /** Returns the number of triangles, which are the first items. */
  int triangleCount() {
    return triangleShape.length;
  }

  /** Copies the nine coordinates of the triangle with the given item number. */
  void copyVertices(int item, double[] target) {
    Mesh mesh = (Mesh) all.get(triangleShape[item]);
    mesh.triangles().copyVertices(triangleElement[item], target);
  }

  /** Returns the triangles in the given order of item numbers. */
  Triangles triangles(int[] order) {
    TriangleMesh[] meshes = new TriangleMesh[all.size()];
    for (int i = 0; i < meshes.length; i++) {
      if (all.get(i) instanceof Mesh mesh) {
        meshes[i] = mesh.triangles();
      }
    }
    int[] shape = new int[order.length];
    int[] element = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      shape[i] = triangleShape[order[i]];
      element[i] = triangleElement[order[i]];
    }
    return new Triangles(meshes, shape, element);
  }

  /** Returns the bounded shapes in the given order of item numbers. */
  LeafShapes shapes(int[] order) {
    int[] numbers = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      numbers[i] = bounded.get(order[i] - triangleCount());
    }
    return leafShapes(numbers);
  }

  /** Returns the unbounded shapes. */
  LeafShapes unbounded() {
    return leafShapes(unbounded.stream().mapToInt(Integer::intValue).toArray());
  }

  private LeafShapes leafShapes(int[] numbers) {
    Shape[] shapes = new Shape[numbers.length];
    for (int i = 0; i < numbers.length; i++) {
      shapes[i] = all.get(numbers[i]);
    }
    return new LeafShapes(shapes, numbers);
  }
}
