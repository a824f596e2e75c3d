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

  /** The triangles of each shape; null for shapes that are no meshes. */
  private final TriangleMesh[] meshes;

  /** The vertices of all meshes; null before they are asked for. */
  private MeshPositions positions;

  /** The boxes of the bounded shapes, six doubles each. */
  private final double[] shapeBoxes;

  /** The box of all items; null before it is asked for. */
  private double[] whole;

  BvhItems(List<Shape> all) {
    this.all = all;
    meshes = new TriangleMesh[all.size()];
    int triangles = 0;
    for (int i = 0; i < all.size(); i++) {
      Shape shape = all.get(i);
      if (shape instanceof Mesh mesh) {
        meshes[i] = mesh.triangles();
        triangles = Math.addExact(triangles, meshes[i].triangleCount());
      } else {
        Bounds3 box = shape.bounds();
        if (!box.isEmpty()) {
          (box.isFinite() ? bounded : unbounded).add(i);
        }
      }
    }
    triangleShape = new int[triangles];
    triangleElement = new int[triangles];
    numberTriangles();
    shapeBoxes = new double[6 * bounded.size()];
    for (int i = 0; i < bounded.size(); i++) {
      Bounds3 box = all.get(bounded.get(i)).bounds();
      store(6 * i, box.min(), box.max());
    }
  }

  private BvhItems(BvhItems source, int[] triangles, boolean hasShapes) {
    all = source.all;
    meshes = source.meshes;
    positions = source.positions();
    triangleShape = new int[triangles.length];
    triangleElement = new int[triangles.length];
    for (int i = 0; i < triangles.length; i++) {
      triangleShape[i] = source.triangleShape[triangles[i]];
      triangleElement[i] = source.triangleElement[triangles[i]];
    }
    bounded.addAll(hasShapes ? source.bounded : List.of());
    shapeBoxes = source.shapeBoxes;
  }

  /** Returns some of the triangles alone. */
  BvhItems ofTriangles(int... triangles) {
    return new BvhItems(this, triangles, false);
  }

  /** Returns the other bounded shapes alone. */
  BvhItems withoutTriangles() {
    return new BvhItems(this, new int[0], true);
  }

  private void numberTriangles() {
    int item = 0;
    for (int shape = 0; shape < meshes.length; shape++) {
      int count = meshes[shape] == null ? 0 : meshes[shape].triangleCount();
      for (int element = 0; element < count; element++, item++) {
        triangleShape[item] = shape;
        triangleElement[item] = element;
      }
    }
  }

  private void store(int at, Vec3 min, Vec3 max) {
    double pad = MARGIN * Math.max(min.maxAbs(), max.maxAbs());
    for (int axis = 0; axis < 3; axis++) {
      shapeBoxes[at + 2 * axis] = min.get(axis) - pad;
      shapeBoxes[at + 2 * axis + 1] = max.get(axis) + pad;
    }
  }

  /** Copies the box of an item: minimum and maximum on x, y, z. */
  void copyBox(int item, double[] target) {
    if (item >= triangleCount()) {
      System.arraycopy(shapeBoxes, 6 * (item - triangleCount()), target, 0, 6);
      return;
    }
    TriangleMesh mesh = meshes[triangleShape[item]];
    double[] positions = mesh.positions();
    int a = 3 * mesh.vertex(triangleElement[item], 0);
    int b = 3 * mesh.vertex(triangleElement[item], 1);
    int c = 3 * mesh.vertex(triangleElement[item], 2);
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
      double p = positions[a + axis];
      double q = positions[b + axis];
      double r = positions[c + axis];
      double min = Math.min(p, Math.min(q, r));
      double max = Math.max(p, Math.max(q, r));
      target[2 * axis] = min;
      target[2 * axis + 1] = max;
      size = Math.max(size, Math.max(-min, max));
    }
    double pad = MARGIN * size;
    for (int k = 0; k < 6; k += 2) {
      target[k] -= pad;
      target[k + 1] += pad;
    }
  }

  boolean isEmpty() {
    return count() == 0;
  }

  int count() {
    return triangleCount() + bounded.size();
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
    double[] box = new double[6];
    int large = 0;
    for (int item = 0; item < count() && large <= count() / 2; item++) {
      copyBox(item, box);
      if (longest(box) >= least) {
        large++;
      }
    }
    return large > count() / 2;
  }

  private double extent() {
    return Math.max(0, longest(box()));
  }

  /** Returns the box of all items; callers must not modify it. */
  double[] box() {
    if (whole == null) {
      whole = ItemBox.empty();
      double[] box = new double[6];
      for (int item = 0; item < count(); item++) {
        copyBox(item, box);
        ItemBox.grow(whole, box);
      }
    }
    return whole;
  }

  private static double longest(double[] box) {
    return Math.max(box[1] - box[0], Math.max(box[3] - box[2], box[5] - box[4]));
  }

  /** Returns the number of triangles, which are the first items. */
  int triangleCount() {
    return triangleShape.length;
  }

  /** Copies the nine coordinates of the triangle with the given item number. */
  void copyVertices(int item, double[] target) {
    meshes[triangleShape[item]].copyVertices(triangleElement[item], target);
  }

  /** Returns the triangles in the given order of item numbers. */
  Triangles triangles(int[] order) {
    int[] shape = new int[order.length];
    int[] element = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      shape[i] = triangleShape[order[i]];
      element[i] = triangleElement[order[i]];
    }
    return new Triangles(meshes, positions(), shape, element);
  }

  private MeshPositions positions() {
    if (positions == null) {
      positions = MeshPositions.of(meshes);
    }
    return positions;
  }

  /** Returns the bounded shapes in the given order of item numbers. */
  LeafShapes shapes(int[] order) {
    int[] numbers = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      numbers[i] = bounded.get(order[i] - triangleCount());
    }
    return leafShapes(numbers);
  }

  LeafShapes unbounded() {
    int[] numbers = new int[unbounded.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = unbounded.get(i);
    }
    return leafShapes(numbers);
  }

  private LeafShapes leafShapes(int[] numbers) {
    Shape[] shapes = new Shape[numbers.length];
    for (int i = 0; i < numbers.length; i++) {
      shapes[i] = all.get(numbers[i]);
    }
    return new LeafShapes(shapes, numbers);
  }
}
