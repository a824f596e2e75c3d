package io.github.lumbre.stage.drawing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Segments joined to chains: where the ends of two segments meet, or where two of more continue
 * each other. Segments of no length belong to none.
 */
final class Chains {
  /** Ends in one cell of a grid with this many cells per pixel are one point. */
  private static final double GRID = 1024;

  /** The least cosine of the turn of a chain where more than two segments meet. */
  private static final double STRAIGHT = .866;

  /** Where more segments meet, all chains end. */
  private static final int MOST_AT_POINT = 32;

  /** The largest distance of points that are left out, in pixels. */
  private static final double FLAT = .02;

  private static final int NONE = -1;

  private final List<double[]> points = new ArrayList<>();

  /** The point of each end of a segment: 2 i and 2 i + 1 of segment i. */
  private int[] pointOf = new int[64];

  private int ends;

  /** The number of each segment among the given ones. */
  private int[] given = new int[32];

  Chains(Strokes segments) {
    Map<Long, Integer> numbers = new HashMap<>();
    for (int i = 0; i < segments.count(); i++) {
      int from = point(segments.coordinate(i, 0), segments.coordinate(i, 1), numbers);
      int to = point(segments.coordinate(i, 2), segments.coordinate(i, 3), numbers);
      if (from != to) {
        if (ends == pointOf.length) {
          pointOf = Arrays.copyOf(pointOf, 2 * ends);
          given = Arrays.copyOf(given, ends);
        }
        given[ends / 2] = i;
        pointOf[ends++] = from;
        pointOf[ends++] = to;
      }
    }
  }

  /**
   * Returns the chains of segments: x and y of each point. The first point of a closed chain is
   * also its last one. Points on a straight line between others are left out.
   */
  static List<double[]> of(Strokes segments) {
    Chains chains = new Chains(segments);
    return chains.joined().stream()
        .map(chain -> Polylines.simplified(chains.line(chain), FLAT))
        .toList();
  }

  /** Returns the numbers of the given segments of each chain, in its order. */
  List<int[]> numbers() {
    return joined().stream()
        .map(chain -> Arrays.stream(chain).map(end -> given[end / 2]).toArray())
        .toList();
  }

  private int point(double x, double y, Map<Long, Integer> numbers) {
    long column = (long) Math.rint(x * GRID);
    long row = (long) Math.rint(y * GRID);
    return numbers.computeIfAbsent(
        Strokes.key(column, row),
        key -> {
          points.add(new double[] {column / GRID, row / GRID});
          return points.size() - 1;
        });
  }

  /** Returns the ends of segments where each segment of a chain begins. */
  private List<int[]> joined() {
    int[] next = next();
    boolean[] isUsed = new boolean[ends / 2];
    List<int[]> chains = new ArrayList<>();
    for (boolean isClosed : List.of(false, true)) {
      for (int end = 0; end < ends; end++) {
        if (!isUsed[end / 2] && (isClosed || next[end] == NONE)) {
          chains.add(chain(end, next, isUsed));
        }
      }
    }
    return chains;
  }

  /** Returns the chain that begins at the end of a segment. */
  private static int[] chain(int start, int[] next, boolean[] isUsed) {
    IntStream.Builder chain = IntStream.builder();
    for (int end = start; end != NONE && !isUsed[end / 2]; end = next[end ^ 1]) {
      isUsed[end / 2] = true;
      chain.add(end);
    }
    return chain.build().toArray();
  }

  private double[] line(int... chain) {
    IntStream after = Arrays.stream(chain).map(end -> pointOf[end ^ 1]);
    return IntStream.concat(IntStream.of(pointOf[chain[0]]), after)
        .mapToObj(points::get)
        .flatMapToDouble(Arrays::stream)
        .toArray();
  }

  /** Returns the end of another segment that continues each end; {@link #NONE} if none does. */
  private int[] next() {
    int[] next = new int[ends];
    Arrays.fill(next, NONE);
    List<List<Integer>> meeting = new ArrayList<>();
    points.forEach(point -> meeting.add(new ArrayList<>(2)));
    for (int end = 0; end < ends; end++) {
      meeting.get(pointOf[end]).add(end);
    }
    for (List<Integer> here : meeting) {
      if (here.size() == 2) {
        link(here.get(0), here.get(1), next);
      } else if (here.size() <= MOST_AT_POINT) {
        linkStraight(here, next);
      }
    }
    return next;
  }

  private static void link(int one, int other, int[] next) {
    next[one] = other;
    next[other] = one;
  }

  /** Links the segments that turn least, as long as there are some. */
  private void linkStraight(List<Integer> here, int[] next) {
    int one = NONE;
    int other = NONE;
    double best = STRAIGHT;
    for (int a : here) {
      for (int b : here) {
        double straight = a < b && next[a] == NONE && next[b] == NONE ? -cos(a, b) : -1;
        if (straight > best) {
          best = straight;
          one = a;
          other = b;
        }
      }
    }
    if (one != NONE) {
      link(one, other, next);
      linkStraight(here, next);
    }
  }

  /** Returns the cosine of the angle between the segments of two ends at one point. */
  private double cos(int a, int b) {
    double[] here = points.get(pointOf[a]);
    double[] one = points.get(pointOf[a ^ 1]);
    double[] other = points.get(pointOf[b ^ 1]);
    double x = one[0] - here[0];
    double y = one[1] - here[1];
    double otherX = other[0] - here[0];
    double otherY = other[1] - here[1];
    return (x * otherX + y * otherY)
        / Math.sqrt((x * x + y * y) * (otherX * otherX + otherY * otherY));
  }
}
