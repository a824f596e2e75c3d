package io.github.lumbre.math.sampling;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.internal.Warp;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

/**
 * Checks the report's statement that the concentric map distributes points over a disk more evenly
 * than the polar map. {@link #main} draws both.
 */
class DiskEvennessTest {
  private static final int SIDE = 16;

  private static Point2 polar(Point2 u) {
    double r = Math.sqrt(u.x());
    return new Point2(r * Elementary.cosTurns(u.y()), r * Elementary.sinTurns(u.y()));
  }

  /** Returns one jittered point for each cell of a square grid, mapped to the disk. */
  private static List<Point2> points(UnaryOperator<Point2> map, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Point2> points = new ArrayList<>();
    for (int i = 0; i < SIDE * SIDE; i++) {
      points.add(
          map.apply(
              new Point2(
                  (i % SIDE + random.nextDouble()) / SIDE,
                  (i / SIDE + random.nextDouble()) / SIDE)));
    }
    return points;
  }

  /**
   * Returns the deviation between the fraction of points in small random disks and the disks'
   * fraction of the area.
   */
  private static double discrepancy(UnaryOperator<Point2> map) {
    SplittableRandom random = new SplittableRandom(7);
    double squares = 0;
    int trials = 0;
    for (int set = 0; set < 40; set++) {
      List<Point2> points = points(map, set);
      for (int i = 0; i < 200; i++) {
        double radius = .1 + .3 * random.nextDouble();
        Point2 center = Warp.concentricDisk(new Point2(random.nextDouble(), random.nextDouble()));
        double x = center.x() * (1 - radius);
        double y = center.y() * (1 - radius);
        long inside =
            points.stream().filter(p -> Math.hypot(p.x() - x, p.y() - y) < radius).count();
        double error = (double) inside / points.size() - radius * radius;
        squares += error * error;
        trials++;
      }
    }
    return Math.sqrt(squares / trials);
  }

  @Test
  void concentricMapIsMoreEvenThanThePolarOne() {
    double concentric = discrepancy(Warp::concentricDisk);
    double polar = discrepancy(DiskEvennessTest::polar);

    // Standard errors are about 2 %; 256 independent points would give about 0.013.
    assertThat(concentric).isLessThan(.95 * polar);
    assertThat(polar).isLessThan(.013);
  }

  /** Returns the smallest distance between the images of two cell centers. */
  private static double closest(UnaryOperator<Point2> map) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < SIDE * SIDE; i++) {
      for (int j = 0; j < i; j++) {
        Point2 p = map.apply(new Point2((i % SIDE + .5) / SIDE, (i / SIDE + .5) / SIDE));
        Point2 q = map.apply(new Point2((j % SIDE + .5) / SIDE, (j / SIDE + .5) / SIDE));
        least = Math.min(least, Math.hypot(p.x() - q.x(), p.y() - q.y()));
      }
    }
    return least;
  }

  @Test
  void concentricMapKeepsNeighboursApart() {
    assertThat(closest(Warp::concentricDisk)).isGreaterThan(2 * closest(DiskEvennessTest::polar));
  }

  /**
   * Draws both point sets side by side, with the concentric one on the left.
   *
   * @param arguments the PNG file to write
   * @throws IOException if it cannot be written
   */
  public static void main(String[] arguments) throws IOException {
    int size = 400;
    float[] rgb = new float[3 * 2 * size * size];
    Arrays.fill(rgb, 1);
    draw(rgb, size, 0, points(Warp::concentricDisk, 0));
    draw(rgb, size, size, points(DiskEvennessTest::polar, 0));
    ImageWriter.write(new Image(2 * size, size, rgb, new float[0]), Path.of(arguments[0]));
  }

  private static void draw(float[] rgb, int size, int left, List<Point2> points) {
    for (Point2 p : points) {
      int x = left + (int) ((.5 + .47 * p.x()) * size);
      int y = (int) ((.5 - .47 * p.y()) * size);
      for (int dy = -2; dy <= 2; dy++) {
        for (int dx = -2; dx <= 2; dx++) {
          if (dx * dx + dy * dy <= 5) {
            int i = 3 * ((y + dy) * 2 * size + x + dx);
            rgb[i] = .02f;
            rgb[i + 1] = .06f;
            rgb[i + 2] = .3f;
          }
        }
      }
    }
  }
}
