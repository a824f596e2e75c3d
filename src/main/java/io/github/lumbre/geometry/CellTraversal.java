package io.github.lumbre.geometry;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * A traversal for few rays among many triangles, such as those of a drawing: triangles are sorted
 * into the cells of a grid, and the hierarchy of a cell is built when the first ray enters the box
 * of its triangles. Thread-safe.
 */
final class CellTraversal implements Traversal {
  /** With fewer triangles, one hierarchy over all of them is built as fast. */
  static final int LEAST_TRIANGLES = 1 << 14;

  /** Cells on each side of the grid. */
  private static final int SIDE = 16;

  /** Cells on each side of a block of cells. */
  private static final int BLOCK_SIDE = 4;

  private static final int BLOCK = BLOCK_SIDE * BLOCK_SIDE * BLOCK_SIDE;
  private static final int CELLS = SIDE * SIDE * SIDE;

  private final BvhItems items;

  /** The other bounded shapes. */
  private final Traversal shapes;

  /** The triangles, grouped by cells, and where each begins. The cells of a block are together. */
  private final int[] order;

  private final int[] first = new int[CELLS + 1];

  /** The boxes around the triangles of cells and blocks, six doubles each; empty ones included. */
  private final double[] cellBoxes = emptyBoxes(CELLS);

  private final double[] blockBoxes = emptyBoxes(CELLS / BLOCK);

  /** The hierarchies of cells; null before they are built. */
  private final AtomicReferenceArray<Traversal> cells = new AtomicReferenceArray<>(CELLS);

  CellTraversal(BvhItems items) {
    this.items = items;
    shapes = Kernel.SCALAR.over(items.withoutTriangles());
    order = new int[items.triangleCount()];
    sort();
  }

  private static double[] emptyBoxes(int count) {
    double[] boxes = new double[ItemBox.SIZE * count];
    for (int i = 0; i < count; i++) {
      System.arraycopy(ItemBox.empty(), 0, boxes, ItemBox.SIZE * i, ItemBox.SIZE);
    }
    return boxes;
  }

  private void sort() {
    short[] cellOf = new short[order.length];
    double[] all = items.box();
    double[] box = new double[ItemBox.SIZE];
    for (int item = 0; item < order.length; item++) {
      cellOf[item] = addToCell(item, all, box);
    }
    for (int cell = 0; cell < CELLS; cell++) {
      first[cell + 1] += first[cell];
      grow(blockBoxes, cell / BLOCK, cellBoxes, cell);
    }
    int[] next = first.clone();
    for (int item = 0; item < order.length; item++) {
      order[next[cellOf[item]]++] = item;
    }
  }

  /** Counts a triangle in its cell, whose box it grows; returns the cell. */
  private short addToCell(int item, double[] all, double[] box) {
    items.copyBox(item, box);
    int x = along(0, all, box);
    int y = along(2, all, box);
    int z = along(4, all, box);
    int block =
        (z / BLOCK_SIDE * (SIDE / BLOCK_SIDE) + y / BLOCK_SIDE) * (SIDE / BLOCK_SIDE)
            + x / BLOCK_SIDE;
    int inner =
        (z % BLOCK_SIDE * BLOCK_SIDE + y % BLOCK_SIDE) * BLOCK_SIDE + x % BLOCK_SIDE;
    int cell = block * BLOCK + inner;
    first[cell + 1]++;
    grow(cellBoxes, cell, box, 0);
    return (short) cell;
  }

  /** Returns the number of the cell along an axis, given by the offset of its minimum in boxes. */
  private static int along(int axis, double[] all, double[] box) {
    // Quarters and halves, whose sums and differences are finite.
    double least = .5 * all[axis];
    double extent = .5 * all[axis + 1] - least;
    double center = .25 * box[axis] + .25 * box[axis + 1];
    return Math.max(0, Math.min(SIDE - 1, (int) ((center - least) / extent * SIDE)));
  }

  private static void grow(double[] boxes, int number, double[] by, int numberBy) {
    int at = ItemBox.SIZE * number;
    ItemBox.storeUnion(boxes, at, by, ItemBox.SIZE * numberBy, boxes, at);
  }

  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    boolean found = shapes.traverse(ox, oy, oz, dx, dy, dz, nearest);
    Slabs slabs = new Slabs(ox, oy, oz, dx, dy, dz);
    for (int block = 0; block < CELLS / BLOCK; block++) {
      if (slabs.enter(blockBoxes, block, nearest.t)) {
        for (int cell = BLOCK * block; cell < BLOCK * (block + 1); cell++) {
          if (found && nearest.any) {
            return true;
          }
          if (first[cell] < first[cell + 1] && slabs.enter(cellBoxes, cell, nearest.t)) {
            found |= cell(cell).traverse(ox, oy, oz, dx, dy, dz, nearest);
          }
        }
      }
    }
    return found;
  }

  private Traversal cell(int cell) {
    Traversal built = cells.get(cell);
    return built == null ? build(cell) : built;
  }

  private synchronized Traversal build(int cell) {
    if (cells.get(cell) == null) {
      int[] triangles = Arrays.copyOfRange(order, first[cell], first[cell + 1]);
      cells.set(cell, Kernel.SCALAR.over(items.ofTriangles(triangles)));
    }
    return cells.get(cell);
  }

  /** A ray, ready for tests of boxes, which it widens as {@link BinaryTraversal} does. */
  private static final class Slabs {
    private final double inX;
    private final double inY;
    private final double inZ;
    private final double outX;
    private final double outY;
    private final double outZ;
    private final double ix;
    private final double iy;
    private final double iz;
    private final int nearX;
    private final int nearY;
    private final int nearZ;

    Slabs(double ox, double oy, double oz, double dx, double dy, double dz) {
      ix = 1 / dx;
      iy = 1 / dy;
      iz = 1 / dz;
      nearX = Axes.sign(dx);
      nearY = 2 + Axes.sign(dy);
      nearZ = 4 + Axes.sign(dz);
      double margin = BvhItems.MARGIN * Axes.largest(ox, oy, oz);
      inX = ox + Math.copySign(margin, ix);
      inY = oy + Math.copySign(margin, iy);
      inZ = oz + Math.copySign(margin, iz);
      outX = ox - Math.copySign(margin, ix);
      outY = oy - Math.copySign(margin, iy);
      outZ = oz - Math.copySign(margin, iz);
    }

    /**
     * Returns whether the ray enters a box before an end, included. NaN occurs only for origins on
     * the widened border, where either result is correct.
     */
    boolean enter(double[] boxes, int number, double end) {
      int at = ItemBox.SIZE * number;
      double near =
          Math.max(
              (boxes[at + nearX] - inX) * ix,
              Math.max((boxes[at + nearY] - inY) * iy, (boxes[at + nearZ] - inZ) * iz));
      double far =
          Math.min(
              (boxes[at + (nearX ^ 1)] - outX) * ix,
              Math.min(
                  (boxes[at + (nearY ^ 1)] - outY) * iy, (boxes[at + (nearZ ^ 1)] - outZ) * iz));
      return !(near > far || near > end || far < 0);
    }
  }
}
