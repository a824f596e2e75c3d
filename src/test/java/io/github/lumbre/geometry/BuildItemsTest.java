package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the integers from which a hierarchy is built. */
class BuildItemsTest {
  private static final int SIZE = BuildItems.SIZE;

  private static List<Shape> boxes(int count, double size, Vec3 corner, SplittableRandom random) {
    List<Shape> shapes = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Vec3 place = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
      Transform toWorld = Transform.translation(corner.plus(place.times(size)));
      shapes.add(new Box(toWorld, .02 * size, .03 * size, .01 * size));
    }
    return shapes;
  }

  /** Coordinates are those of the boxes, in units of the longest edge of all, rounded down. */
  @Test
  void integersFollowTheBoxes() {
    SplittableRandom random = new SplittableRandom(1);
    BvhItems source = new BvhItems(boxes(50, 7, new Vec3(-3, 100, 4), random));
    BuildItems items = new BuildItems(source, WideTree.COSTS);
    double[] all = items.box(0, 50);
    double extent = Math.max(all[1] - all[0], Math.max(all[3] - all[2], all[5] - all[4]));
    double[] box = new double[6];
    for (int i = 0; i < 50; i++) {
      source.copyBox(i, box);
      for (int k = 0; k < 6; k++) {
        double exact = (box[k] - all[k & ~1]) / extent * BuildItems.REACH;
        assertThat((double) items.array()[SIZE * i + k]).isCloseTo(exact - .5, within(1.5));
      }
    }
    int[] array = items.array();
    assertThat(Arrays.stream(array).max().orElseThrow()).isBetween(BuildItems.REACH - 1, 1 << 30);
  }

  /** Points, infinite differences and subnormal extents yield integers in the allowed range. */
  @Test
  void extremeBoxesStayInRange() {
    SplittableRandom random = new SplittableRandom(3);
    for (double size : new double[] {1e-322, 1e-320, 1e-300, 1, 1e300, 1.7e308}) {
      double[] positions = random.doubles(90).map(x -> (2 * x - 1) * size).toArray();
      int[] indices = IntStream.range(0, 30).toArray();
      TriangleMesh mesh = TriangleMesh.of(positions, new double[0], new double[0], indices);
      assertThat(mesh.triangleCount()).isPositive();
      BvhItems source = new BvhItems(List.of(Mesh.baked(mesh, Transform.IDENTITY)));
      BuildItems items = new BuildItems(source, BinaryTraversal.COSTS);
      for (int i = 0; i < source.count(); i++) {
        for (int k = 0; k < 6; k++) {
          assertThat(items.array()[SIZE * i + k]).isBetween(0, BuildItems.REACH);
        }
      }
      assertThat(built(List.of(Mesh.baked(mesh, Transform.IDENTITY)), BinaryTraversal.COSTS).box())
          .isEqualTo(items.box(0, source.count()));
    }
  }

  @Test
  void kindsAreSeparated() {
    TriangleMesh triangle =
        TriangleMesh.of(
            new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
            new double[0],
            new double[0],
            new int[] {0, 1, 2, 2, 1, 0, 0, 2, 1});
    Shape mesh = Mesh.baked(triangle, Transform.IDENTITY);
    Shape box = new Box(Transform.IDENTITY, 1, 1, 1);
    BuildItems items = new BuildItems(new BvhItems(List.of(box, mesh, box)), WideTree.COSTS);
    assertThat(items.order()).containsExactly(0, 1, 2, 3, 4);
    BuildItems.swap(items.array(), 0, SIZE * 4);
    BuildItems.swap(items.array(), SIZE, SIZE * 3);
    assertThat(items.order()).containsExactly(4, 3, 2, 1, 0);
    assertThat(items.partitionKinds(0, 5)).isEqualTo(3);
    assertThat(items.order()).startsWith(2, 1, 0);
  }

  /** Returns the six walls of a room from -size to size, two triangles each. */
  private static Shape room(double size) {
    double[] positions = new double[24];
    for (int k = 0; k < 24; k++) {
      positions[k] = (k / 3 >> k % 3 & 1) == 0 ? -size : size;
    }
    int[][] walls = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}};
    List<Integer> indices = new ArrayList<>(List.of(1, 3, 7, 1, 7, 5));
    for (int[] wall : walls) {
      indices.addAll(List.of(wall[0], wall[1], wall[2], wall[0], wall[2], wall[3]));
    }
    int[] corners = indices.stream().mapToInt(i -> i).toArray();
    TriangleMesh mesh = TriangleMesh.of(positions, new double[0], new double[0], corners);
    return Mesh.baked(mesh, Transform.IDENTITY);
  }

  private static int separated(List<Shape> shapes) {
    return new BuildItems(new BvhItems(shapes), WideTree.COSTS).partitionLarge();
  }

  @Test
  void wallsAreSeparatedFromContents() {
    List<Shape> shapes = boxes(50, 1, Vec3.ZERO, new SplittableRandom(4));
    assertThat(separated(shapes)).isZero();
    shapes.add(room(2));
    assertThat(separated(shapes)).isEqualTo(12);
    shapes.add(new Box(Transform.IDENTITY, 2, 1, .5));
    shapes.add(new Box(Transform.IDENTITY, 1, 2, .5));
    BuildItems items = new BuildItems(new BvhItems(shapes), WideTree.COSTS);
    assertThat(items.partitionLarge()).isEqualTo(14);
    assertThat(items.order())
        .startsWith(IntStream.concat(IntStream.range(0, 12), IntStream.of(62, 63)).toArray());
    assertThat(items.order()).containsExactlyInAnyOrder(IntStream.range(0, 64).toArray());
  }

  /** If there are no other items, or many large ones, none is separated. */
  @Test
  void wallsAreSeparatedInRoomsOnly() {
    assertThat(separated(List.of(room(2)))).isZero();
    List<Shape> shapes = boxes(50, 1, Vec3.ZERO, new SplittableRandom(4));
    shapes.add(room(2));
    shapes.add(room(1.5));
    assertThat(separated(shapes)).isZero();
    assertThat(separated(List.of(new Box(Transform.IDENTITY, 1, 1, 1)))).isZero();
  }

  /** Each wall is a leaf of its own, and the contents of the room are one subtree. */
  @Test
  void wallsAreLeavesOfTheirOwn() {
    List<Shape> shapes = boxes(50, 1, Vec3.ZERO, new SplittableRandom(4));
    TreeNode contents = built(shapes, WideTree.COSTS);
    shapes.add(room(2));
    TreeNode.Inner root = (TreeNode.Inner) built(shapes, WideTree.COSTS);
    assertThat(root.right().box()).isEqualTo(contents.box());
    List<TreeNode.Leaf> walls = new ArrayList<>();
    addLeaves(root.left(), walls);
    assertThat(walls).hasSize(6);
    for (TreeNode.Leaf wall : walls) {
      assertThat(wall.end() - wall.first()).isEqualTo(2);
      double[] box = wall.box();
      double thinnest = Math.min(box[1] - box[0], Math.min(box[3] - box[2], box[5] - box[4]));
      assertThat(thinnest).isLessThan(1e-12);
    }
  }

  private static TreeNode built(List<? extends Shape> shapes, LeafCost costs) {
    return TreeNode.of(new BvhBuilder(new BvhItems(List.copyOf(shapes)), costs).build());
  }

  private static void addLeaves(TreeNode node, List<TreeNode.Leaf> leaves) {
    if (node instanceof TreeNode.Leaf leaf) {
      leaves.add(leaf);
    } else if (node instanceof TreeNode.Inner inner) {
      addLeaves(inner.left(), leaves);
      addLeaves(inner.right(), leaves);
    }
  }

  private static double surface(TreeNode node) {
    double own = ItemBox.halfArea(node.box());
    return node instanceof TreeNode.Inner inner
        ? own + surface(inner.left()) + surface(inner.right())
        : own;
  }

  /** Returns the node of the given number of items. */
  private static TreeNode find(TreeNode node, double[] box) {
    while (!Arrays.equals(node.box(), box)) {
      TreeNode.Inner inner = (TreeNode.Inner) node;
      double[] left = inner.left().box();
      node = left[0] <= box[0] && left[1] >= box[1] ? inner.left() : inner.right();
    }
    return node;
  }

  /** A cluster far smaller than the resolution of the whole gets as good a tree as alone. */
  @Test
  void tinyClustersAreSplitWell() {
    List<Shape> cluster = boxes(500, 0x1p-40, Vec3.ZERO, new SplittableRandom(2));
    TreeNode alone = built(cluster, BinaryTraversal.COSTS);
    List<Shape> scene = new ArrayList<>(cluster);
    scene.add(new Box(Transform.translation(new Vec3(1000, 0, 0)), 5, 5, 5));
    TreeNode whole = built(scene, BinaryTraversal.COSTS);
    assertThat(surface(find(whole, alone.box()))).isCloseTo(surface(alone), within(1e-26));
    assertThat(surface(alone)).isGreaterThan(1e-24);
  }
}
