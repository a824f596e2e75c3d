package io.github.lumbre.model.explosion;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.explosion.Spread.Item;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * A tree of bodies that move apart: those of a group first, then the group as a whole. Add all
 * groups and bodies, then explode. Mutable; confined to one thread.
 */
public final class Assembly {
  /** Of more bodies, only those of one level of the tree move apart. */
  public static final int MOST_BODIES = 500;

  /** The largest side of the box around all, relative to the longest side before. */
  public static final int LARGEST = 3;

  /** The number of the group that has all others. */
  public static final int ROOT = 0;

  /** Gaps between bodies to try, relative to the longest side of their group. */
  private static final List<Double> GAPS = List.of(.04, .02, .01, 1e-3, 1e-6);

  /** Overlaps below this share of the longest side are rounding errors. */
  private static final double ROUNDING = 1e-9;

  private static final int HALVINGS = 60;

  /** Factors of moves to try along axes that are not those of the boxes. */
  private static final List<Double> FARTHER = List.of(1., 1.25, 1.5, 2., 2.5, 3., 4., 5., 6., 8.);

  private static final int MOST_NAMED = 5;

  /** Groups and bodies: each has a larger number than the group that it belongs to. */
  private final List<Entry> entries = new ArrayList<>();

  private final List<Integer> bodies = new ArrayList<>();

  private final Frame axes;

  /**
   * A group or a body.
   *
   * @param box along the axes of the file
   * @param turned the box around the same along the axes of the assembly
   */
  private record Entry(int group, Bounds3 box, Bounds3 turned, List<Integer> members) {
    boolean isBody() {
      return !box.isEmpty();
    }
  }

  /**
   * Where the bodies go.
   *
   * @param moves the vector of each body, in the order in which they were added
   * @param overlapping the first pairs of bodies that still overlap, by their numbers
   * @param overlaps the number of all these pairs
   * @param level the number of items that move as wholes, if not each body does; otherwise 0
   */
  public record Moves(
      List<Vec3> moves, List<List<Integer>> overlapping, long overlaps, int level) {}

  /**
   * Creates an assembly without bodies.
   *
   * @param axes along which bodies move
   */
  public Assembly(Frame axes) {
    this.axes = axes;
    entries.add(new Entry(-1, Bounds3.EMPTY, Bounds3.EMPTY, new ArrayList<>()));
  }

  /** Adds a group to another one, and returns its number. */
  public int addGroup(int group) {
    return add(group, Bounds3.EMPTY, Bounds3.EMPTY);
  }

  /**
   * Adds a body to a group.
   *
   * @param box around it along the axes of the file, not empty
   * @param turned the box around it along the axes of the assembly
   */
  public void addBody(int group, Bounds3 box, Bounds3 turned) {
    bodies.add(add(group, box, turned));
  }

  private int add(int group, Bounds3 box, Bounds3 turned) {
    entries.get(group).members.add(entries.size());
    entries.add(new Entry(group, box, turned, new ArrayList<>()));
    return entries.size() - 1;
  }

  /** Returns where the bodies go. */
  public Moves exploded() {
    Bounds3[] boxes = boxes(Entry::box);
    Bounds3[] turned = boxes(Entry::turned);
    double most = LARGEST * longest(boxes[ROOT]);
    if (bodies.size() > MOST_BODIES) {
      return ofLevel(boxes, turned, most);
    }
    List<Vec3> moves = List.of();
    for (boolean isTree : List.of(true, false)) {
      for (double gap : GAPS) {
        moves =
            isTree
                ? ofTree(boxes, turned, gap)
                : together(bodies, boxes, turned, gap * longest(boxes[ROOT]));
        if (longest(around(bodies, boxes, moves)) <= most) {
          return new Moves(moves, List.of(), 0, 0);
        }
      }
    }
    int[] each = IntStream.range(0, entries.size()).toArray();
    return ended(boxes, shortened(bodies, boxes, moves, most), each, 0);
  }

  /**
   * Returns moves so many times as long that no two boxes overlap; empty if they would need more
   * than {@link #LARGEST} allows.
   */
  public static Optional<List<Vec3>> apart(List<Bounds3> boxes, List<Vec3> moves) {
    Bounds3[] all = boxes.toArray(Bounds3[]::new);
    List<Integer> items = IntStream.range(0, all.length).boxed().toList();
    double longest = longest(boxes.stream().reduce(Bounds3.EMPTY, Bounds3::union));
    for (double factor : FARTHER) {
      List<Vec3> farther = moves.stream().map(move -> move.times(factor)).toList();
      if (longest(around(items, all, farther)) > LARGEST * longest) {
        return Optional.empty();
      }
      if (areApart(boxes, farther, ROUNDING * longest)) {
        return Optional.of(farther);
      }
    }
    return Optional.empty();
  }

  private static boolean areApart(List<Bounds3> boxes, List<Vec3> moves, double least) {
    for (int i = 0; i < boxes.size(); i++) {
      Interrupts.check();
      Bounds3 box = moved(boxes.get(i), moves.get(i));
      for (int j = 0; j < i; j++) {
        if (overlap(box, moved(boxes.get(j), moves.get(j)), least)) {
          return false;
        }
      }
    }
    return true;
  }

  /** Returns the box around each group and body. */
  private Bounds3[] boxes(Function<Entry, Bounds3> of) {
    Bounds3[] boxes = new Bounds3[entries.size()];
    for (int i = entries.size() - 1; i >= 0; i--) {
      Bounds3 box = of.apply(entries.get(i));
      for (int member : entries.get(i).members) {
        box = box.union(boxes[member]);
      }
      boxes[i] = box;
    }
    return boxes;
  }

  /** Moves the bodies of each group apart, then the groups. */
  private List<Vec3> ofTree(Bounds3[] boxes, Bounds3[] turned, double gap) {
    Bounds3[] grown = boxes.clone();
    Vec3[] moves = new Vec3[entries.size()];
    Arrays.fill(moves, Vec3.ZERO);
    for (int i = entries.size() - 1; i >= 0; i--) {
      List<Integer> members = members(i, boxes);
      if (!members.isEmpty()) {
        List<Item> items = members.stream().map(m -> new Item(turned[m], grown[m])).toList();
        List<Vec3> apart = Spread.of(items, axes, gap * least(longest(boxes[i])));
        Bounds3 all = Bounds3.EMPTY;
        for (int m = 0; m < members.size(); m++) {
          moves[members.get(m)] = apart.get(m);
          all = all.union(moved(grown[members.get(m)], apart.get(m)));
        }
        grown[i] = all;
      }
    }
    for (int i = 1; i < moves.length; i++) {
      moves[i] = moves[i].plus(moves[entries.get(i).group]);
    }
    return bodies.stream().map(body -> moves[body]).toList();
  }

  private List<Integer> members(int group, Bounds3[] boxes) {
    return entries.get(group).members.stream().filter(m -> !boxes[m].isEmpty()).toList();
  }

  /** Moves the members of the first group apart that has several, each as a whole. */
  private Moves ofLevel(Bounds3[] boxes, Bounds3[] turned, double most) {
    int group = ROOT;
    List<Integer> members = members(group, boxes);
    while (members.size() == 1 && !entries.get(members.get(0)).isBody()) {
      group = members.get(0);
      members = members(group, boxes);
    }
    List<Vec3> moves = List.of();
    for (double gap : GAPS) {
      moves = together(members, boxes, turned, gap * longest(boxes[ROOT]));
      if (longest(around(members, boxes, moves)) <= most) {
        break;
      }
    }
    moves = shortened(members, boxes, moves, most);
    Vec3[] ofEntries = new Vec3[entries.size()];
    int[] memberOf = new int[entries.size()];
    for (int m = 0; m < members.size(); m++) {
      memberOf[members.get(m)] = members.get(m);
      ofEntries[members.get(m)] = moves.get(m);
    }
    for (int i = 1; i < memberOf.length; i++) {
      memberOf[i] = memberOf[i] > 0 ? memberOf[i] : memberOf[entries.get(i).group];
    }
    List<Vec3> ofBodies = bodies.stream().map(body -> ofEntries[memberOf[body]]).toList();
    return ended(boxes, ofBodies, memberOf, members.size() < bodies.size() ? members.size() : 0);
  }

  private List<Vec3> together(
      List<Integer> items, Bounds3[] boxes, Bounds3[] turned, double gap) {
    List<Item> each = items.stream().map(i -> new Item(turned[i], boxes[i])).toList();
    return Spread.of(each, axes, least(gap));
  }

  private static double least(double gap) {
    return gap > 0 ? gap : 1;
  }

  /** Returns shorter moves along the axes on which the box around all would be too long. */
  private static List<Vec3> shortened(
      List<Integer> items, Bounds3[] boxes, List<Vec3> moves, double most) {
    double[] factors = new double[Direction.AXES];
    for (int axis = 0; axis < factors.length; axis++) {
      double low = 0;
      double high = 1;
      for (int i = 0; i < HALVINGS && side(items, boxes, moves, axis, high) > most; i++) {
        double half = .5 * (low + high);
        boolean isShort = side(items, boxes, moves, axis, half) <= most;
        low = isShort ? half : low;
        high = isShort ? high : half;
      }
      factors[axis] = side(items, boxes, moves, axis, high) <= most ? high : low;
    }
    return moves.stream()
        .map(m -> new Vec3(factors[0] * m.x(), factors[1] * m.y(), factors[2] * m.z()))
        .toList();
  }

  /** Returns a side of the box around items that move by a factor of their moves. */
  private static double side(
      List<Integer> items, Bounds3[] boxes, List<Vec3> moves, int axis, double factor) {
    double min = Double.POSITIVE_INFINITY;
    double max = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < moves.size(); i++) {
      double move = factor * moves.get(i).get(axis);
      min = Math.min(min, boxes[items.get(i)].min().get(axis) + move);
      max = Math.max(max, boxes[items.get(i)].max().get(axis) + move);
    }
    return max - min;
  }

  private static Bounds3 around(List<Integer> items, Bounds3[] boxes, List<Vec3> moves) {
    return IntStream.range(0, moves.size())
        .mapToObj(i -> moved(boxes[items.get(i)], moves.get(i)))
        .reduce(Bounds3.EMPTY, Bounds3::union);
  }

  private static Bounds3 moved(Bounds3 box, Vec3 move) {
    return new Bounds3(box.min().plus(move), box.max().plus(move));
  }

  private static double longest(Bounds3 box) {
    return box.isEmpty() ? 0 : box.max().minus(box.min()).maxAbs();
  }

  /**
   * Returns moves, with the pairs that overlap by more than rounding errors.
   *
   * @param memberOf what each entry moves with, whose bodies may overlap
   */
  private Moves ended(Bounds3[] boxes, List<Vec3> moves, int[] memberOf, int level) {
    double least = ROUNDING * longest(boxes[ROOT]);
    List<List<Integer>> first = new ArrayList<>();
    long count = 0;
    for (int i = 0; i < moves.size(); i++) {
      Interrupts.check();
      Bounds3 a = moved(boxes[bodies.get(i)], moves.get(i));
      for (int j = i + 1; j < moves.size(); j++) {
        Bounds3 b = moved(boxes[bodies.get(j)], moves.get(j));
        if (memberOf[bodies.get(i)] != memberOf[bodies.get(j)] && overlap(a, b, least)) {
          count++;
          if (first.size() < MOST_NAMED) {
            first.add(List.of(i, j));
          }
        }
      }
    }
    return new Moves(moves, first, count, level);
  }

  private static boolean overlap(Bounds3 a, Bounds3 b, double least) {
    for (int axis = 0; axis < Direction.AXES; axis++) {
      if (Direction.distance(a, b, axis) >= -least) {
        return false;
      }
    }
    return true;
  }
}
