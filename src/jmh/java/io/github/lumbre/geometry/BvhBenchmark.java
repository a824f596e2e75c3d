package io.github.lumbre.geometry;

import io.github.lumbre.MicroBenchmark;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/**
 * Finding what rays meet: incoherent ones, from a sphere around the shapes to points in its inside.
 * For any hit they end there, as shadow rays do, so that many meet nothing.
 */
public class BvhBenchmark extends MicroBenchmark {
  private static final double FAR = 3;

  @Param({"MESH", "BOXES"})
  private BenchmarkShapes shapes;

  private final NearestHit hit = new NearestHit();
  private Bvh bvh;
  private Ray[] rays;
  private Ray[] segments;

  @Setup
  public void prepare() {
    bvh = Bvh.over(shapes.make());
    SplittableRandom random = new SplittableRandom(1);
    rays = new Ray[COUNT];
    segments = new Ray[COUNT];
    for (int i = 0; i < COUNT; i++) {
      Vec3 origin = inBall(random).normalized().times(FAR);
      Vec3 way = inBall(random).minus(origin);
      rays[i] = new Ray(origin, way.normalized());
      segments[i] = new Ray(origin, way.normalized(), way.length());
    }
  }

  private static Vec3 inBall(SplittableRandom random) {
    Vec3 point;
    do {
      point =
          new Vec3(
              2 * random.nextDouble() - 1,
              2 * random.nextDouble() - 1,
              2 * random.nextDouble() - 1);
    } while (point.lengthSquared() > 1);
    return point;
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public double closestHit() {
    double sum = 0;
    for (Ray ray : rays) {
      sum += bvh.intersect(ray, hit) ? hit.t() : 0;
    }
    return sum;
  }

  @Benchmark
  @OperationsPerInvocation(COUNT)
  public int anyHit() {
    int count = 0;
    for (Ray ray : segments) {
      count += bvh.isOccluded(ray, hit) ? 1 : 0;
    }
    return count;
  }
}
