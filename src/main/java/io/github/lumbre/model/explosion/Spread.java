package io.github.lumbre.model.explosion;

import static io.github.lumbre.model.explosion.Direction.AXES;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Moves boxes apart. Two boxes that overlap, or would meet on their ways, keep their order along
 * one axis, and a gap there. What is above others on an axis is pushed up just as far as they need,
 * and what is below is pushed down; each box goes to the middle of both places. Confined to one
 * thread.
 */
final class Spread {
  /** More pairs are not moved apart. */
  private static final int MOST_PAIRS = 1_000_000;

  /** Centers are on one height if they differ less, relative to the longest side of all. */
  private static final double LEVEL = 1e-6;

  /** Moves along an axis at a larger angle to one of the file do not take boxes apart there. */
  private static final double ACROSS = 1e-3;

  private final List<Item> items;
  private final double gap;

  /** The axes along which items move. */
  private final Frame axes;

  private final List<Vec3> directions;

  /** For each axis, the items from the lowest to the highest. */
  private final int[][] order = new int[AXES][];

  /** For each axis and item, its place in the order. */
  private final int[][] places = new int[AXES][];

  /** For each axis and item, the items that must stay below it. */
  private final List<List<List<Integer>>> below = new ArrayList<>();

  /** For each item, the later ones with which it has an order on an axis. */
  private final BitSet[] known;

  private final Vec3[] moves;
  private int pairs;

  /**
   * A body, or a group of bodies.
   *
   * @param box around it in the assembled model, along the axes of its moves
   * @param grown the box around it once its own bodies have moved apart, along those of the file
   */
  record Item(Bounds3 box, Bounds3 grown) {}

  private Spread(List<Item> items, Frame axes, double gap) {
    this.items = items;
    this.axes = axes;
    directions = List.of(axes.tangent(), axes.bitangent(), axes.normal());
    this.gap = gap;
    int count = items.size();
    known = new BitSet[count];
    Arrays.setAll(known, i -> new BitSet());
    moves = new Vec3[count];
    Arrays.fill(moves, Vec3.ZERO);
    Bounds3 all = items.stream().map(Item::box).reduce(Bounds3.EMPTY, Bounds3::union);
    double level = LEVEL * all.max().minus(all.min()).maxAbs();
    for (int axis = 0; axis < AXES; axis++) {
      order[axis] = order(axis, level > 0 ? level : 1);
      places[axis] = new int[count];
      for (int place = 0; place < count; place++) {
        places[axis][order[axis][place]] = place;
      }
      below.add(IntStream.range(0, count).<List<Integer>>mapToObj(i -> new ArrayList<>()).toList());
    }
  }

  /** Returns the items by their centers; of those on one height, the largest is the lowest. */
  private int[] order(int axis, double level) {
    return IntStream.range(0, items.size())
        .boxed()
        .sorted(
            Comparator.comparingDouble(
                    (Integer i) -> Math.rint(items.get(i).box.center().get(axis) / level))
                .thenComparingDouble(i -> -items.get(i).box.radius())
                .thenComparingInt(i -> i))
        .mapToInt(i -> i)
        .toArray();
  }

  /**
   * Returns the vectors by which items move.
   *
   * @param axes along which they move
   * @param gap the least distance between them, more than 0
   */
  static List<Vec3> of(List<Item> items, Frame axes, double gap) {
    Spread spread = new Spread(items, axes, gap);
    spread.add((i, j) -> overlap(items.get(i).box, items.get(j).box));
    do {
      spread.move();
    } while (spread.add(spread::collide));
    return Arrays.stream(spread.moves).map(axes::toWorld).toList();
  }

  private interface Pairs {
    boolean has(int i, int j);
  }

  /** Adds pairs that have no order yet; returns whether there are some. */
  private boolean add(Pairs wanted) {
    int before = pairs;
    for (int i = 0; i < items.size(); i++) {
      Interrupts.check();
      for (int j = i + 1; j < items.size() && pairs < MOST_PAIRS; j++) {
        if (!known[i].get(j) && wanted.has(i, j)) {
          add(i, j);
        }
      }
    }
    return pairs > before;
  }

  private void add(int i, int j) {
    int axis = Direction.of(items.get(i).box, items.get(j).box);
    boolean isBelow = places[axis][i] < places[axis][j];
    below.get(axis).get(isBelow ? j : i).add(isBelow ? i : j);
    known[i].set(j);
    pairs++;
  }

  private static boolean overlap(Bounds3 a, Bounds3 b) {
    return IntStream.range(0, AXES).allMatch(axis -> Direction.distance(a, b, axis) < 0);
  }

  /** Returns whether two items come too near, at the end or on their ways. */
  private boolean collide(int i, int j) {
    Item a = items.get(i);
    Item b = items.get(j);
    Vec3 move = moves[j].minus(moves[i]);
    Vec3 shown = axes.toWorld(move);
    boolean isNear = true;
    for (int axis = 0; axis < AXES; axis++) {
      double up = b.grown.min().get(axis) + shown.get(axis) - a.grown.max().get(axis);
      double down = a.grown.min().get(axis) - b.grown.max().get(axis) - shown.get(axis);
      isNear &= Math.max(up, down) < gap;
    }
    return isNear || meet(a.box, b.box, move);
  }

  /** Returns whether a box meets another one, which moves in a straight line. */
  private static boolean meet(Bounds3 a, Bounds3 b, Vec3 move) {
    double from = 0;
    double to = 1;
    for (int axis = 0; axis < AXES; axis++) {
      double step = move.get(axis);
      double low = a.min().get(axis) - b.max().get(axis);
      double high = a.max().get(axis) - b.min().get(axis);
      if (step == 0) {
        to = low < 0 && high > 0 ? to : -1;
      } else {
        from = Math.max(from, Math.min(low / step, high / step));
        to = Math.min(to, Math.max(low / step, high / step));
      }
    }
    return from < to;
  }

  /** Moves all items by the orders of their pairs. */
  private void move() {
    double[][] middle = new double[AXES][];
    for (int axis = 0; axis < AXES; axis++) {
      middle[axis] = middle(axis);
    }
    Arrays.setAll(moves, i -> new Vec3(middle[0][i], middle[1][i], middle[2][i]));
  }

  private double[] middle(int axis) {
    double[] up = new double[items.size()];
    for (int i : order[axis]) {
      for (int lower : below.get(axis).get(i)) {
        up[i] = Math.max(up[i], up[lower] + push(lower, i, axis));
      }
    }
    double[] down = new double[items.size()];
    for (int place = items.size() - 1; place >= 0; place--) {
      int i = order[axis][place];
      for (int lower : below.get(axis).get(i)) {
        down[lower] = Math.min(down[lower], down[i] - push(lower, i, axis));
      }
    }
    Arrays.setAll(up, i -> .5 * (up[i] + down[i]));
    return up;
  }

  /** Returns how far apart two items must move along an axis; negative if they need not. */
  private double push(int lower, int upper, int axis) {
    Bounds3 a = items.get(lower).grown;
    Bounds3 b = items.get(upper).grown;
    double least = Double.POSITIVE_INFINITY;
    for (int k = 0; k < AXES; k++) {
      double step = directions.get(axis).get(k);
      double way =
          step > 0
              ? a.max().get(k) + gap - b.min().get(k)
              : b.max().get(k) + gap - a.min().get(k);
      if (Math.abs(step) > ACROSS) {
        least = Math.min(least, way / Math.abs(step));
      }
    }
    return least;
  }
}
