package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.geometry.internal.CompiledKernel;
import io.github.lumbre.geometry.internal.HierarchyLimitException;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The change of a hierarchy from plain Java to vectors. */
class KernelChangeTest {
  private static final Bounds3 AROUND = new Bounds3(new Vec3(-9, -9, -9), new Vec3(9, 9, 9));

  private final NearestHit found = new NearestHit();
  private final NearestHit expected = new NearestHit();
  private final Random random = new Random(11);

  @BeforeEach
  void startUncompiled() throws InterruptedException {
    assumeTrue(Kernel.vectorObstacle().isEmpty(), () -> Kernel.vectorObstacle().orElseThrow());
    CompiledVectors.forget();
  }

  @AfterEach
  void forget() throws InterruptedException {
    CompiledVectors.forget();
  }

  /** Returns a mesh, another one placed twice, and a few other shapes. */
  private List<Shape> shapes() {
    List<Shape> shapes = new ArrayList<>(Shapes.zoo(random, 20));
    shapes.add(Mesh.baked(Shapes.closedBall(30, 40, .2, false), Transform.IDENTITY));
    SharedMesh shared = new SharedMesh(Shapes.closedBall(20, 20, .2, false));
    shapes.add(new MeshInstance(shared, Transform.translation(new Vec3(3, 0, 0))));
    shapes.add(new MeshInstance(shared, Transform.translation(new Vec3(-3, 0, 0))));
    return shapes;
  }

  private void assertSameHits(Bvh bvh, Bvh scalar) {
    int hits = 0;
    for (int i = 0; i < 5000; i++) {
      Ray ray = Shapes.ray(random, AROUND);
      boolean isHit = scalar.intersect(ray, expected);
      assertThat(bvh.intersect(ray, found)).isEqualTo(isHit);
      assertThat(found.shape).isEqualTo(expected.shape);
      if (isHit) {
        assertThat(found.t).isEqualTo(expected.t);
        hits++;
      }
      assertThat(bvh.isOccluded(ray, found)).isEqualTo(isHit);
    }
    assertThat(hits).isGreaterThan(100);
  }

  @Test
  void startsWithPlainJavaAndChangesToVectors() throws InterruptedException {
    List<Shape> shapes = shapes();
    Bvh scalar = Bvh.over(shapes, Kernel.SCALAR);
    Bvh bvh = Bvh.over(shapes);
    KernelChange change = KernelChange.of(bvh, shapes);
    assertThat(change.isPossible()).isTrue();
    assertThat(bvh.bounded()).isInstanceOf(BinaryTraversal.class);
    assertSameHits(bvh, scalar);

    assertThat(change.run(() -> true)).isTrue();

    assertThat(bvh.bounded()).isNotInstanceOf(BinaryTraversal.class);
    MeshInstance instance = (MeshInstance) shapes.get(shapes.size() - 1);
    assertThat(instance.shared().bvh().bounded()).isNotInstanceOf(BinaryTraversal.class);
    assertSameHits(bvh, scalar);
    assertThat(change.isPossible()).isFalse();
    assertThat(change.run(() -> true)).isFalse();
    Bvh later = Bvh.over(shapes);
    assertThat(later.bounded()).isNotInstanceOf(BinaryTraversal.class);
    assertThat(KernelChange.of(later, shapes()).isPossible()).isFalse();
  }

  @Test
  void searchesGoOnDuringTheChange() throws InterruptedException {
    List<Shape> shapes = shapes();
    Bvh scalar = Bvh.over(shapes, Kernel.SCALAR);
    Bvh bvh = Bvh.over(shapes);
    Thread changing =
        new Thread(
            () -> {
              try {
                KernelChange.of(bvh, shapes).run(() -> true);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    changing.start();
    while (changing.isAlive()) {
      assertSameHits(bvh, scalar);
    }
    assertSameHits(bvh, scalar);
    assertThat(bvh.bounded()).isNotInstanceOf(BinaryTraversal.class);
  }

  /** A mesh may fit into the scalar kernel and not into the vector kernel. */
  @Test
  void meshesWithoutPlaceStayInPlainJava() throws InterruptedException {
    List<Shape> mesh =
        List.of(Mesh.baked(Shapes.closedBall(30, 40, .2, false), Transform.IDENTITY));
    Bvh bvh = Bvh.over(mesh);
    KernelChange change = KernelChange.of(List.of(bvh), mesh, 1000);
    assertThat(change.run(() -> true)).isFalse();
    assertThat(change.isPossible()).isFalse();
    assertThat(bvh.bounded()).isInstanceOf(BinaryTraversal.class);

    BvhItems items = new BvhItems(mesh);
    CompiledKernel.setCompiled(true);
    assertThat(Kernel.AUTO.over(items, 10000)).isNotInstanceOf(BinaryTraversal.class);
    assertThat(Kernel.AUTO.over(items, 1000)).isInstanceOf(BinaryTraversal.class);
    assertThatThrownBy(() -> Kernel.VECTOR.over(items, 1000))
        .isInstanceOf(HierarchyLimitException.class)
        .hasMessageContaining("the vector kernel has no place");
  }

  @Test
  void chosenKernelsStay() {
    for (Kernel kernel : List.of(Kernel.SCALAR, Kernel.VECTOR)) {
      List<Shape> mesh =
          List.of(Mesh.baked(Shapes.closedBall(30, 40, .2, false), Transform.IDENTITY));
      assertThat(KernelChange.of(Bvh.over(mesh, kernel), mesh).isPossible()).isFalse();
    }
  }

  @Test
  void fewItemsStayInPlainJava() throws InterruptedException {
    List<Shape> few = List.of(new Sphere(Transform.IDENTITY, 1));
    KernelChange change = KernelChange.of(Bvh.over(few), few);
    assertThat(change.isPossible()).isFalse();
    assertThat(change.run(() -> true)).isFalse();
  }

  @Test
  void interruptedChangeChangesNothing() {
    List<Shape> shapes = shapes();
    Bvh bvh = Bvh.over(shapes);
    KernelChange change = KernelChange.of(bvh, shapes);
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> change.run(() -> true)).isInstanceOf(InterruptedException.class);
    assertThat(bvh.bounded()).isInstanceOf(BinaryTraversal.class);
    assertThat(CompiledKernel.isCompiled()).isFalse();
  }

  @Test
  void changeThatIsNoLongerWantedStopsAndMayBeTriedAgain() throws InterruptedException {
    List<Shape> shapes = shapes();
    Bvh bvh = Bvh.over(shapes);
    KernelChange change = KernelChange.of(bvh, shapes);
    assertThat(change.run(() -> false)).isFalse();
    assertThat(bvh.bounded()).isInstanceOf(BinaryTraversal.class);
    assertThat(change.isPossible()).isTrue();
  }
}
