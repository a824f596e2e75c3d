package io.github.lumbre.model.section;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.model.section.Outlines.Region;
import io.github.lumbre.model.section.Triangulation.TooMuchException;
import io.github.lumbre.testing.Effort;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Regions are those of the nonzero winding rule, and their triangles meet at whole edges. */
class OutlinesTest {
  private static final int GRID = Triangulation.GRID;
  private static final int QUICK = 300;
  private static final int MANY = 100_000;
  private static final int PROBES = 40;

  /** Distinct points and segments between them. */
  private record Input(int[] x, int[] y, int[] segments) {
    /** Returns closed polygons, whose equal points are joined. */
    static Input of(int[][]... polygons) {
      Map<Long, Integer> numbers = new LinkedHashMap<>();
      IntStream.Builder segments = IntStream.builder();
      for (int[][] polygon : polygons) {
        for (int i = 0; i < polygon.length; i++) {
          segments.add(number(numbers, polygon[i]));
          segments.add(number(numbers, polygon[(i + 1) % polygon.length]));
        }
      }
      return new Input(
          numbers.keySet().stream().mapToInt(key -> (int) (key >> 32)).toArray(),
          numbers.keySet().stream().mapToInt(Long::intValue).toArray(),
          segments.build().toArray());
    }

    private static int number(Map<Long, Integer> numbers, int... point) {
      Integer known = numbers.putIfAbsent((long) point[0] << 32 | point[1], numbers.size());
      return known == null ? numbers.size() - 1 : known;
    }

    Region region() {
      return Outlines.region(x, y, segments);
    }

    /** Returns the winding number at a point, by the segments that a ray to the right crosses. */
    int winding(double px, double py) {
      int winding = 0;
      for (int i = 0; i < segments.length; i += 2) {
        double ax = x[segments[i]];
        double ay = y[segments[i]];
        double bx = x[segments[i + 1]];
        double by = y[segments[i + 1]];
        boolean isUp = ay <= py && by > py;
        boolean isDown = by <= py && ay > py;
        if ((isUp || isDown) && ax + (py - ay) / (by - ay) * (bx - ax) > px) {
          winding += isUp ? 1 : -1;
        }
      }
      return winding;
    }

    /** Returns the distance of a point to the next segment. */
    double distance(double px, double py) {
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < segments.length; i += 2) {
        double dx = x[segments[i + 1]] - (double) x[segments[i]];
        double dy = y[segments[i + 1]] - (double) y[segments[i]];
        double ex = px - x[segments[i]];
        double ey = py - y[segments[i]];
        double length = dx * dx + dy * dy;
        double s = length == 0 ? 0 : Math.max(0, Math.min(1, (ex * dx + ey * dy) / length));
        double fx = ex - s * dx;
        double fy = ey - s * dy;
        least = Math.min(least, Math.sqrt(fx * fx + fy * fy));
      }
      return least;
    }
  }

  private static boolean covers(Region region, double px, double py) {
    int[] c = region.corners();
    for (int i = 0; i < c.length; i += 3) {
      boolean isInside = true;
      for (int k = 0; k < 3; k++) {
        int a = c[i + k];
        int b = c[i + (k + 1) % 3];
        double dx = region.x(b) - (double) region.x(a);
        double dy = region.y(b) - (double) region.y(a);
        isInside &= dx * (py - region.y(a)) - dy * (px - region.x(a)) >= 0;
      }
      if (isInside) {
        return true;
      }
    }
    return false;
  }

  /** Returns the area in units of the grid, squared. */
  private static double area(Region region) {
    double sum = 0;
    int[] c = region.corners();
    for (int i = 0; i < c.length; i += 3) {
      double abx = region.x(c[i + 1]) - (double) region.x(c[i]);
      double aby = region.y(c[i + 1]) - (double) region.y(c[i]);
      double acx = region.x(c[i + 2]) - (double) region.x(c[i]);
      double acy = region.y(c[i + 2]) - (double) region.y(c[i]);
      double twice = abx * acy - aby * acx;
      assertThat(twice).isPositive();
      sum += twice / 2;
    }
    return sum;
  }

  /** Checks that no directed edge occurs twice, so that triangles do not overlap along edges. */
  private static void requireConforming(Region region) {
    Map<Long, Integer> edges = new HashMap<>();
    int[] c = region.corners();
    for (int i = 0; i < c.length; i++) {
      int next = i % 3 == 2 ? i - 2 : i + 1;
      assertThat(edges.merge((long) c[i] << 32 | c[next], 1, Integer::sum)).isEqualTo(1);
    }
  }

  private static int[][] square(int from, int to) {
    return new int[][] {{from, from}, {to, from}, {to, to}, {from, to}};
  }

  private static int[][] reversed(int[][] polygon) {
    int[][] result = polygon.clone();
    Arrays.setAll(result, i -> polygon[polygon.length - 1 - i]);
    return result;
  }

  @Test
  void squareIsTwoTriangles() {
    Region region = Input.of(square(0, 10)).region();
    assertThat(region.corners()).hasSize(6);
    assertThat(area(region)).isEqualTo(100);
  }

  @Test
  void holesAreTurnedTheOtherWay() {
    assertThat(area(Input.of(square(0, 10), reversed(square(2, 6))).region())).isEqualTo(84);
    assertThat(area(Input.of(square(0, 10), square(2, 6)).region())).isEqualTo(100);
    assertThat(area(Input.of(reversed(square(0, 10))).region())).isEqualTo(100);
  }

  @Test
  void outlinesThatCrossAndTouchAreUnited() {
    assertThat(area(Input.of(square(0, 10), square(5, 15)).region())).isEqualTo(175);
    assertThat(area(Input.of(square(0, 10), square(10, 20)).region())).isEqualTo(200);
    assertThat(area(Input.of(square(0, 10), reversed(square(0, 10))).region())).isZero();
    assertThat(area(Input.of(new int[][] {{0, 0}, {10, 10}, {10, 0}, {0, 10}}).region()))
        .isEqualTo(50);
  }

  private static Input random(Random random) {
    // Few places make points and edges coincide.
    int side = new int[] {3, 8, 50, 10_000, GRID}[random.nextInt(5)];
    int[][][] polygons = new int[1 + random.nextInt(4)][][];
    for (int i = 0; i < polygons.length; i++) {
      polygons[i] = new int[3 + random.nextInt(random.nextInt(8) == 0 ? 60 : 9)][];
      Arrays.setAll(
          polygons[i], k -> new int[] {random.nextInt(side + 1), random.nextInt(side + 1)});
    }
    return Input.of(polygons);
  }

  private static void requireNonzeroWinding(Random random) {
    Input input = random(random);
    Region region = input.region();
    area(region);
    requireConforming(region);
    double side = Arrays.stream(input.x).max().orElse(0) + 1;
    for (int i = 0; i < PROBES; i++) {
      double px = random.nextDouble() * side;
      double py = random.nextDouble() * side;
      // Crossings move outlines by up to a unit each, and seldom all in one direction.
      if (input.distance(px, py) > 4) {
        assertThat(covers(region, px, py)).isEqualTo(input.winding(px, py) != 0);
      }
    }
  }

  @Test
  void regionsHaveTheNonzeroWindingRule() {
    for (int seed = 0; seed < QUICK; seed++) {
      requireNonzeroWinding(new Random(seed));
    }
  }

  @Test
  @Tag("fuzz")
  void manyRegionsHaveTheNonzeroWindingRule() {
    Random seeds = new Random(Effort.seed(1));
    for (int i = 0; i < MANY; i++) {
      requireNonzeroWinding(new Random(seeds.nextLong()));
    }
  }

  @Test
  void workIsBounded() {
    Random random = new Random(1);
    int[][] polygon = new int[30_000][];
    Arrays.setAll(polygon, i -> new int[] {random.nextInt(GRID), random.nextInt(GRID)});
    assertThatThrownBy(() -> Input.of(polygon).region()).isInstanceOf(TooMuchException.class);
  }

  @Test
  void roundOutlinesOfManyPointsAreFilled() {
    int count = 100_000;
    int[][] circle = new int[count][];
    for (int i = 0; i < count; i++) {
      double angle = 2 * Math.PI * i / count;
      circle[i] =
          new int[] {
            (int) (GRID / 2 * (1 + Math.cos(angle))), (int) (GRID / 2 * (1 + Math.sin(angle)))
          };
    }
    double expected = Math.PI / 4 * GRID * (double) GRID;
    // The polygon and the rounding to the grid lack less than 1e-7 of the circle.
    assertThat(area(Input.of(circle).region()) / expected)
        .isCloseTo(1, org.assertj.core.api.Assertions.within(1e-6));
  }
}
