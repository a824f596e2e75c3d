package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.LongAdder;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which kernel {@link Kernel} chooses, and the boxes that it is given. */
class KernelChoiceTest {
  @BeforeEach
  void assumeVectors() {
    assumeTrue(Kernel.vectorObstacle().isEmpty(), () -> Kernel.vectorObstacle().orElseThrow());
  }

  /** Returns boxes in a row along an axis, from 0 to a number, with a size along another axis. */
  private static List<Shape> row(int count, int axis, int longAxis, double size) {
    List<Shape> boxes = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      boxes.add(box(axis(axis).times(i), longAxis, size));
    }
    return boxes;
  }

  private static Vec3 axis(int axis) {
    return List.of(Vec3.X, Vec3.Y, Vec3.Z).get(axis);
  }

  private static Box box(Vec3 at, int longAxis, double size) {
    double[] sides = {1e-14, 1e-14, 1e-14};
    sides[longAxis] = size;
    return new Box(Transform.translation(at), sides[0], sides[1], sides[2]);
  }

  /** Returns whether a kernel uses vectors, at once or as soon as they are compiled. */
  private static boolean usesVectors(Kernel kernel, List<Shape> shapes) {
    BvhItems items = new BvhItems(shapes);
    return kernel.mayChange(items) || !(kernel.over(items) instanceof BinaryTraversal);
  }

  @Test
  void fewItemsAreSearchedInPlainJava() {
    assertThat(usesVectors(Kernel.AUTO, row(5, 0, 0, .5))).isFalse();
    assertThat(usesVectors(Kernel.AUTO, row(6, 0, 0, .5))).isTrue();
  }

  @Test
  void otherKernelsAreUsedAlways() {
    assertThat(usesVectors(Kernel.VECTOR, row(1, 0, 0, .5))).isTrue();
    assertThat(usesVectors(Kernel.SCALAR, row(50, 0, 0, .5))).isFalse();
  }

  /** An item is as large as its longest side, and is compared with the longest side of them all. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void itemsThatAreTinyInTheirSceneAreSearchedInPlainJava(int axis) {
    for (int longAxis = 0; longAxis < 3; longAxis++) {
      assertThat(usesVectors(Kernel.AUTO, row(10, axis, longAxis, .5))).isTrue();
      assertThat(usesVectors(Kernel.AUTO, row(10, axis, longAxis, 1e-12))).isFalse();
    }
  }

  @Test
  void mostItemsDecide() {
    List<Shape> mixed = row(5, 0, 1, 1e-12);
    mixed.addAll(row(5, 2, 1, .5));
    assertThat(usesVectors(Kernel.AUTO, mixed)).isFalse();
    mixed.add(box(Vec3.Y, 1, .5));
    assertThat(usesVectors(Kernel.AUTO, mixed)).isTrue();
  }

  @Test
  void infinitelyWideItemsAreSearchedInPlainJava() {
    List<Shape> wide = new ArrayList<>(row(6, 0, 0, .5));
    assertThat(usesVectors(Kernel.VECTOR, wide)).isTrue();
    for (double x : new double[] {-1.2e308, 1.2e308}) {
      wide.add(new Box(Transform.translation(new Vec3(0, x, 0)), 1, 1, 1));
    }
    assertThat(usesVectors(Kernel.VECTOR, wide)).isFalse();
    assertThat(usesVectors(Kernel.AUTO, wide)).isFalse();
  }

  @Test
  void nothingIsSearchedWithoutItems() {
    BvhItems none = new BvhItems(List.of(new Plane(Transform.IDENTITY, true)));
    assertThat(Kernel.AUTO.over(none)).isSameAs(Traversal.NONE);
    assertThat(Kernel.counting(none, new LongAdder())).isSameAs(Traversal.NONE);
  }

  @Test
  void boxesOfItemsContainThemWithALittleRoom() {
    Random random = new Random(8);
    TriangleMesh mesh =
        TriangleMesh.of(
            new double[] {-5, 1, 2, 3, 4, -9, 1, -2, 1, 1e3, 1e3, 7, -20, 3, 1, 2, 2, 2},
            new double[0],
            new double[0],
            new int[] {0, 1, 2, 3, 4, 5});
    for (int i = 0; i < 20; i++) {
      Transform place = Transform.translation(Shapes.point(random, 100));
      List<Shape> shapes = List.of(Mesh.baked(mesh, place), new Sphere(place, 3));
      BvhItems items = new BvhItems(shapes);
      assertThat(items.count()).isEqualTo(3);
      double[] vertices = new double[9];
      double[] box = new double[6];
      for (int item = 0; item < 3; item++) {
        Bounds3 expected;
        if (item < 2) {
          items.copyVertices(item, vertices);
          Vec3 a = new Vec3(vertices[0], vertices[1], vertices[2]);
          assertThat(a.minus(place.point(mesh.position(3 * item))).maxAbs()).isZero();
          TriangleMesh one = mesh.part(new int[] {item});
          expected = Mesh.baked(one, place).bounds();
        } else {
          expected = shapes.get(1).bounds();
        }
        items.copyBox(item, box);
        for (int axis = 0; axis < 3; axis++) {
          double low = box[2 * axis];
          double high = box[2 * axis + 1];
          assertThat(low).isLessThan(expected.min().get(axis));
          assertThat(high).isGreaterThan(expected.max().get(axis));
          assertThat(low).isCloseTo(expected.min().get(axis), within(1e-6));
          assertThat(high).isCloseTo(expected.max().get(axis), within(1e-6));
        }
      }
    }
  }
}
